#include <burnish/output/join_parts.h>

#include <burnish/base/atomic_file.h>
#include <burnish/base/error.h>
#include <burnish/input/exr_header.h>

#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfTiledInputPart.h>
#include <OpenEXR/ImfTiledOutputPart.h>

#include <memory>
#include <set>

namespace burnish {
namespace {

std::unique_ptr<Imf::MultiPartInputFile> open(const std::string& file) {
    check_exr_header(file);
    try {
        return std::make_unique<Imf::MultiPartInputFile>(file.c_str());
    } catch (const std::exception& error) {
        throw Error(ErrorCode::read_failed, file + ": cannot be read: " + error.what());
    }
}

/// A header as it may stand in a file of several parts.
Imf::Header part_header(const Imf::Header& own, const StoredParts& source, std::set<std::string>& names) {
    Imf::Header header = own;
    if (!header.hasType()) header.setType(header.hasTileDescription() ? Imf::TILEDIMAGE : Imf::SCANLINEIMAGE);
    if (!source.view.empty() && !header.hasView()) header.setView(source.view);
    const std::string name = header.hasName() && !header.name().empty() ? header.name() : source.name;
    std::string unique = name;
    for (int number = 2; !names.insert(unique).second; ++number) unique = name + "_" + std::to_string(number);
    header.setName(unique);
    return header;
}

void copy_part(Imf::MultiPartInputFile& from, int part, Imf::MultiPartOutputFile& to, int place) {
    if (from.header(part).type() == Imf::TILEDIMAGE) {
        Imf::TiledInputPart tiles(from, part);
        Imf::TiledOutputPart(to, place).copyPixels(tiles);
    } else {
        Imf::InputPart rows(from, part);
        Imf::OutputPart(to, place).copyPixels(rows);
    }
}

}  // namespace

void join_parts(const std::string& target, const std::vector<StoredParts>& sources) {
    std::vector<std::unique_ptr<Imf::MultiPartInputFile>> files;
    std::vector<Imf::Header> headers;
    std::set<std::string> names;
    for (const StoredParts& source : sources) {
        files.push_back(open(source.file));
        for (int part = 0; part < files.back()->parts(); ++part)
            headers.push_back(part_header(files.back()->header(part), source, names));
    }
    AtomicFile joined(target);
    try {
        constexpr bool kFirstHeaderRules = true;  // of attributes that all parts share, such as the display window
        Imf::MultiPartOutputFile output(joined.hidden_path().c_str(), headers.data(), static_cast<int>(headers.size()),
                                        kFirstHeaderRules);
        int place = 0;
        for (const auto& file : files)
            for (int part = 0; part < file->parts(); ++part) copy_part(*file, part, output, place++);
    } catch (const std::exception& error) {
        joined.fail(error.what());
    }
    joined.commit();
}

}  // namespace burnish

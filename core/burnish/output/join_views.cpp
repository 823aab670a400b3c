#include <burnish/output/join_views.h>

#include <burnish/base/atomic_file.h>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfMultiView.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>

#include <algorithm>
#include <memory>

namespace burnish {
namespace {

constexpr int kRowsAtOnce = 64;
constexpr size_t kLargestValue = 4;  // bytes

/// One view on its way into the channels of its name, some rows at a time.
class ViewRows {
public:
    ViewRows(const std::string& file, const Imf::StringVector& views, int view)
        : m_file(std::make_unique<Imf::InputFile>(file.c_str())), m_views(views), m_view(view) {
        const size_t bytes = static_cast<size_t>(width()) * kRowsAtOnce * kLargestValue;
        for (auto channel = channels().begin(); channel != channels().end(); ++channel) m_rows.emplace_back(bytes);
    }

    const Imf::Header& header() const { return m_file->header(); }
    const Imf::ChannelList& channels() const { return header().channels(); }
    std::string name_of(const std::string& channel) const { return Imf::insertViewName(channel, m_views, m_view); }

    /// Rows [top, bottom] into the buffers that `out` then speaks of.
    void read(int top, int bottom, Imf::FrameBuffer& out) {
        Imf::FrameBuffer in;
        auto rows = m_rows.begin();
        for (auto channel = channels().begin(); channel != channels().end(); ++channel, ++rows) {
            const ptrdiff_t bytes = channel.channel().type == Imf::HALF ? 2 : 4;
            const ptrdiff_t first = header().dataWindow().min.x + static_cast<ptrdiff_t>(top) * width();
            const Imf::Slice slice(channel.channel().type, rows->data() - first * bytes, static_cast<size_t>(bytes),
                                   static_cast<size_t>(bytes * width()));
            in.insert(channel.name(), slice);
            out.insert(name_of(channel.name()), slice);
        }
        m_file->setFrameBuffer(in);
        m_file->readPixels(top, bottom);
    }

private:
    ptrdiff_t width() const { return header().dataWindow().size().x + 1; }

    std::unique_ptr<Imf::InputFile> m_file;
    Imf::StringVector m_views;
    int m_view;
    std::vector<std::vector<char>> m_rows;  // of each channel
};

void write_joined(const std::string& file, const std::vector<StoredParts>& sources) {
    Imf::StringVector names;
    for (const StoredParts& source : sources) names.push_back(source.view);
    std::vector<ViewRows> views;
    for (const StoredParts& source : sources) views.emplace_back(source.file, names, static_cast<int>(views.size()));
    Imf::Header header = views.front().header();
    header.erase("view");
    header.channels() = {};
    for (const ViewRows& view : views)
        for (auto channel = view.channels().begin(); channel != view.channels().end(); ++channel)
            header.channels().insert(view.name_of(channel.name()), channel.channel());
    Imf::addMultiView(header, names);
    Imf::OutputFile output(file.c_str(), header);
    const int last = header.dataWindow().max.y;
    for (int top = header.dataWindow().min.y; top <= last; top += kRowsAtOnce) {
        const int bottom = std::min(top + kRowsAtOnce - 1, last);
        Imf::FrameBuffer rows;
        for (ViewRows& view : views) view.read(top, bottom, rows);
        output.setFrameBuffer(rows);
        output.writePixels(bottom - top + 1);
    }
}

}  // namespace

void join_views(const std::string& target, const std::vector<StoredParts>& views) {
    AtomicFile joined(target);
    try {
        write_joined(joined.hidden_path().string(), views);
    } catch (const std::exception& error) {
        joined.fail(error.what());
    }
    joined.commit();
}

}  // namespace burnish

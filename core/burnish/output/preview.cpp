#include <burnish/base/atomic_file.h>
#include <burnish/base/error.h>
#include <burnish/output/preview.h>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>

namespace burnish {
namespace {

constexpr int kLineWidth = 2;       // pixels
constexpr float kLineValue = 0.6f;  // display code value

/// The first three channels as display code values.
Image displayed(const Image& image, const PreviewSettings& settings) {
    if (image.channels < 3)
        throw Error(ErrorCode::bad_argument,
                    "a preview needs three channels, the image has " + std::to_string(image.channels) + "; give RGB");
    const float gain = std::exp2(settings.exposure_stops);
    Image rgb(image.width, image.height, 3);
    for (size_t i = 0; i < image.pixel_count(); ++i)
        for (int c = 0; c < 3; ++c) {
            const float value = image.at(i)[c] * gain;
            rgb.at(i)[c] = std::isnan(value) ? 0.0f : value;
        }
    apply_view(rgb, settings.space, settings.display, settings.view, settings.config ? *settings.config : ColorConfig::load());
    return rgb;
}

/// Copies `from` into `to`, its left edge at `column`.
void paste(const Image& from, int column, Image& to) {
    for (int y = 0; y < from.height; ++y)
        std::copy_n(from.at(0, y), static_cast<size_t>(from.width) * from.channels, to.at(column, y));
}

std::string lower_extension(const std::string& file) {
    std::string extension = std::filesystem::path(file).extension().string();
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return extension;
}

OIIO::ImageSpec png_spec(const std::string& file, int width, int height, int channels) {
    if (lower_extension(file) != ".png")
        throw Error(ErrorCode::bad_argument, file + ": previews are PNG files; end the name in .png");
    OIIO::ImageSpec spec(width, height, channels, OIIO::TypeUInt8);
    if (channels == 3)
        spec.attribute("oiio:ColorSpace", "sRGB");
    else
        spec.attribute("oiio:UnassociatedAlpha", 1);
    return spec;
}

/// A PNG of which rows are appended from the top: there when finished, else never.
class PngFile {
public:
    PngFile(const std::string& file, int width, int height, int channels = 3)
        : m_spec(png_spec(file, width, height, channels)),
          m_target(file),
          m_stream(m_target.handle(), OIIO::Filesystem::IOProxy::Write),
          m_output(OIIO::ImageOutput::create("png", &m_stream)) {
        if (!m_output || !m_output->open(file, m_spec)) m_target.fail(m_output ? m_output->geterror() : OIIO::geterror());
    }

    void append(const Image& picture, int above, int below) {
        const int count = picture.height - above - below;
        if (!m_output->write_scanlines(m_rows, m_rows + count, 0, OIIO::TypeFloat, picture.at(0, above)))
            m_target.fail(m_output->geterror());
        m_rows += count;
    }

    void finish() {
        if (!m_output->close()) m_target.fail(m_output->geterror());
        m_target.commit();
    }

private:
    OIIO::ImageSpec m_spec;
    AtomicFile m_target;
    OIIO::Filesystem::IOFile m_stream;
    std::unique_ptr<OIIO::ImageOutput> m_output;  // goes before its stream
    int m_rows = 0;                               // appended
};

}  // namespace

struct PreviewWriter::State {
    PngFile png;
    PreviewSettings settings;
};

PreviewWriter::PreviewWriter(const std::string& file, int width, int height, const PreviewSettings& settings)
    : m_state(new State{{file, width, height}, settings}) {}

PreviewWriter::~PreviewWriter() = default;

void PreviewWriter::append(const Image& image, int above, int below) {
    m_state->png.append(displayed(image, m_state->settings), above, below);
}

void PreviewWriter::finish() { m_state->png.finish(); }

void write_code_values(const std::string& file, const Image& picture) {
    PngFile png(file, picture.width, picture.height, picture.channels);
    png.append(picture, 0, 0);
    png.finish();
}

void write_preview(const std::string& file, const Image& image, const PreviewSettings& settings) {
    write_code_values(file, displayed(image, settings));
}

void write_before_after(const std::string& file, const Image& before, const Image& after, const PreviewSettings& settings) {
    if (before.height != after.height)
        throw Error(ErrorCode::size_mismatch, file + ": the images to compare are " + std::to_string(before.height) + " and " +
                                                  std::to_string(after.height) + " pixels high");
    Image both(before.width + kLineWidth + after.width, before.height, 3, kLineValue);
    paste(displayed(before, settings), 0, both);
    paste(displayed(after, settings), before.width + kLineWidth, both);
    write_code_values(file, both);
}

}  // namespace burnish

#include <burnish/base/parallel.h>
#include <burnish/output/exr_pixels.h>

#include <Imath/half.h>

#include <algorithm>
#include <cstring>

namespace burnish {
namespace {

constexpr float kLargestHalf = 65504.0f;
constexpr int kRowsAtOnce = 64;  // four ZIP blocks; keeps the interleaved copy small

Imath::half to_half(float value) { return Imath::half(std::clamp(value, -kLargestHalf, kLargestHalf)); }

/// One channel of one row: every `stride`-th byte of `to` begins a value.
template <class Convert>
void store(const float* from, int step, int width, size_t stride, char* to, const Convert& convert) {
    for (int x = 0; x < width; ++x, from += step, to += stride) {
        const auto value = convert(*from);
        std::memcpy(to, &value, sizeof value);
    }
}

/// One row of all layers, channels interleaved, each in its own type.
void interleave(const std::vector<OutputLayer>& layers, const OIIO::ImageSpec& spec, int row, char* to) {
    const size_t stride = spec.pixel_bytes(true);
    int channel = 0;
    for (const OutputLayer& layer : layers)
        for (int c = 0; c < layer.image->channels; ++c, ++channel) {
            const OIIO::TypeDesc type = spec.channelformat(channel);
            const float* from = layer.image->at(0, row) + c;
            if (type == OIIO::TypeHalf)
                store(from, layer.image->channels, spec.width, stride, to, to_half);
            else
                store(from, layer.image->channels, spec.width, stride, to, [](float value) { return value; });
            to += type.size();
        }
}

}  // namespace

/// OpenImageIO writes several parts to a file of a name only, not to a stream.
LayerFile::LayerFile(const std::string& file, const std::vector<OIIO::ImageSpec>& parts)
    : m_parts(parts),
      m_target(file),
      m_stream(m_target.handle(), OIIO::Filesystem::IOProxy::Write),
      m_output(OIIO::ImageOutput::create("openexr", parts.size() == 1 ? &m_stream : nullptr)) {
    const std::string name = parts.size() == 1 ? file : m_target.hidden_path().string();
    if (!m_output || !m_output->open(name, static_cast<int>(m_parts.size()), m_parts.data()))
        m_target.fail(m_output ? m_output->geterror() : OIIO::geterror());
}

void LayerFile::append(const std::vector<OutputLayer>& layers, int begin, int end) {
    const OIIO::ImageSpec& spec = m_output->spec();
    const size_t row_bytes = spec.scanline_bytes(true);
    std::vector<char> rows;
    for (int top = begin; top < end; top += kRowsAtOnce) {
        const int count = std::min(kRowsAtOnce, end - top), y = spec.y + m_rows;
        rows.resize(static_cast<size_t>(count) * row_bytes);
        for_each_index(count, [&](int row) { interleave(layers, spec, top + row, rows.data() + row * row_bytes); });
        if (!m_output->write_scanlines(y, y + count, 0, OIIO::TypeUnknown, rows.data())) m_target.fail(m_output->geterror());
        m_rows += count;
    }
}

void LayerFile::next_part() {
    m_rows = 0;
    if (!m_output->open(m_target.hidden_path().string(), m_parts[++m_part], OIIO::ImageOutput::AppendSubimage))
        m_target.fail(m_output->geterror());
}

void LayerFile::finish() {
    if (!m_output->close()) m_target.fail(m_output->geterror());
    m_output.reset();  // textures stay open after close(); the writer must be gone before its stream is
    m_target.commit();
}

void write_layers(const std::string& file, const OIIO::ImageSpec& spec, const std::vector<OutputLayer>& layers) {
    LayerFile target(file, spec);
    target.append(layers, 0, spec.height);
    target.finish();
}

}  // namespace burnish

#include <burnish/frequency/local_bandwidth.h>

#include <burnish/base/error.h>
#include <burnish/frequency/band_maps.h>

#include <algorithm>
#include <bit>
#include <string>
#include <vector>

namespace burnish {
namespace {

int wrapped(int i, int size) { return (i % size + size) % size; }

float surrounded_value(const Image& image, int x, int y, Surround surround) {
    const bool inside = y >= 0 && y < image.height;
    switch (surround) {
        case Surround::zero: return inside && x >= 0 && x < image.width ? *image.at(x, y) : 0.0f;
        case Surround::repeat: return *image.at(wrapped(x, image.width), wrapped(y, image.height));
        case Surround::latlong: break;
    }
    const int down = wrapped(y, 2 * image.height);  // down one meridian, up the opposite one
    const bool opposite = down >= image.height;
    return *image.at(wrapped(opposite ? x + image.width / 2 : x, image.width), opposite ? 2 * image.height - 1 - down : down);
}

Image surrounded_by(const Image& image, int bands, Surround surround) {
    const int border = surround_width(bands), step = 1 << bands;
    const auto whole = [&](int size) { return (size + 2 * border + step - 1) / step * step; };
    Image out(whole(image.width), whole(image.height), 1);
    for (int y = 0; y < out.height; ++y) {
        for (int x = 0; x < out.width; ++x) *out.at(x, y) = surrounded_value(image, x - border, y - border, surround);
    }
    return out;
}

/// The limits of the finest band's cells, one row at a time.
class CellLimits {
public:
    CellLimits(const BandMaps& maps, const BandwidthSettings& settings)
        : m_maps(maps), m_settings(settings), m_energies(maps.bands.size() + 1) {}

    float at(int x, int y) {
        const int last = m_maps.count() - 1;
        for (int band = 0; band <= last; ++band) m_energies[band] = *m_maps.bands[band].at(x >> band, y >> band);
        m_energies[last + 1] = *m_maps.below.at(x >> last, y >> last);
        const float visible = m_settings.contrast * *m_maps.level.at(x >> last, y >> last), constant = visible * visible;
        return m_settings.rule == BandRule::energy
                   ? energy_band_limit(m_energies, constant, m_settings.quantile, m_settings.octaves)
                   : maxima_band_limit(m_energies, constant, m_settings.epsilon);
    }

private:
    const BandMaps& m_maps;
    const BandwidthSettings& m_settings;
    std::vector<float> m_energies;
};

}  // namespace

int band_count(int size) { return std::max(1, static_cast<int>(std::bit_width(static_cast<unsigned>(size))) - 4); }

Image surrounded_bandwidth(const Image& surrounded, int width, int height, int bands, const BandwidthSettings& settings) {
    const BandGather gather = settings.rule == BandRule::energy ? BandGather::mean : BandGather::largest;
    const BandMaps maps = band_maps(surrounded, bands, gather);
    CellLimits limits(maps, settings);
    const int first = surround_width(bands) / 2;
    Image nu(width, height, 1);
    for (int y = 0; y < height; y += 2) {
        for (int x = 0; x < width; x += 2) {
            const float limit = limits.at(first + x / 2, first + y / 2);
            for (int row = y; row < std::min(y + 2, height); ++row) std::fill_n(nu.at(x, row), std::min(2, width - x), limit);
        }
    }
    return nu;
}

Image local_bandwidth(const Image& image, const BandwidthSettings& settings) {
    if (image.channels != 1 || image.empty())
        throw Error(ErrorCode::size_mismatch, "bandwidth: expected an image of one channel, found " +
                                                  std::to_string(image.width) + " x " + std::to_string(image.height) + " x " +
                                                  std::to_string(image.channels) + ". Take one channel or the luminance.");
    const int bands = band_count(std::min(image.width, image.height));
    return surrounded_bandwidth(surrounded_by(image, bands, settings.surround), image.width, image.height, bands, settings);
}

Image spatial_bandwidth(const Image& image, float width, float height, const BandwidthSettings& settings) {
    Image nu = local_bandwidth(image, settings);
    const float samples = std::max(static_cast<float>(image.width) / width, static_cast<float>(image.height) / height);
    for (float& value : nu.data) value *= samples;
    return nu;
}

}  // namespace burnish

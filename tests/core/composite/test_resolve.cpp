// Samples become pixels: against sums written out by hand, at edges, and where the windows of the two frames differ.
#include "core/scenes.h"

#include <burnish/base/error.h>
#include <burnish/composite/resolve.h>

#include <gtest/gtest.h>

#include <random>

using namespace burnish;

namespace {

constexpr int kPixels = 8, kFactor = 4, kSamples = kPixels * kFactor;
constexpr Window kFrame{0, 0, kPixels, kPixels}, kFine{0, 0, kSamples, kSamples};
constexpr PixelFilter kBox{FilterKind::box, 1}, kWide{FilterKind::blackman_harris, 1.5f};

struct RandomSamples {
    Image overlay = Image(kSamples, kSamples, 3);
    PixelVector<float> coverage;

    RandomSamples() {
        std::mt19937 random(5);
        std::uniform_real_distribution<float> uniform(0, 1);
        for (float& value : overlay.data) value = 4 * uniform(random);
        for (int i = 0; i < kSamples * kSamples; ++i) coverage.push_back(std::max(2 * uniform(random) - 1, 0.0f));
    }
};

/// Mean over what is covered of one pixel, sample by sample.
double written_out(const RandomSamples& samples, const PixelFilter& filter, int px, int py, int channel) {
    const FilterTaps taps = filter_taps(filter, kFactor);
    double sum = 0, covered = 0;
    for (int j = 0; j < static_cast<int>(taps.weights.size()); ++j)
        for (int i = 0; i < static_cast<int>(taps.weights.size()); ++i) {
            const int x = px * kFactor - taps.reach + i, y = py * kFactor - taps.reach + j;
            if (x < 0 || y < 0 || x >= kSamples || y >= kSamples) continue;
            const double weight = double(taps.weights[i]) * taps.weights[j] * samples.coverage[y * kSamples + x];
            sum += weight * samples.overlay.at(x, y)[channel], covered += weight;
        }
    return covered > 0 ? sum / covered : 0;
}

AovFrame frame_with(const Window& display, const Window& data, const std::string& name) {
    AovFrame frame;
    frame.file = name, frame.display_window = display, frame.data_window = data;
    return frame;
}

}  // namespace

TEST(Resolve, IsTheWeightedMeanOfWhatIsCovered) {
    const RandomSamples samples;
    for (const PixelFilter& filter : {kBox, kWide, PixelFilter{FilterKind::triangle, 3}}) {
        const Image mean = Resolver({kFactor, 0, 0}, filter, kFine, kFrame).mean(samples.overlay, samples.coverage);
        for (int y = 0; y < kPixels; ++y)
            for (int x = 0; x < kPixels; ++x)
                for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean.at(x, y)[c], written_out(samples, filter, x, y, c), 2e-5);
    }
}

TEST(Resolve, SamplesWithoutSurfaceAddNothingAndTakeNothing) {
    AovFrame fine = scenes::sphere_frame(kSamples);
    Assignment assignment = scenes::whole_frame(fine);
    for (size_t i = 0; i < assignment.rule.size(); ++i)  // the lower half is of no material
        if (fine.layer(Role::normal).at(i)[1] < 0) assignment.rule[i] = -1, assignment.coverage[i] = 0;
    const Surfaces surfaces(fine, assignment, {});
    for (size_t i = 0; i < assignment.rule.size(); ++i)
        if (surfaces.validity(i) != Validity::valid) assignment.coverage[i] = 0;
    const Resolver resolver({kFactor, 0, 0}, kBox, kFine, kFrame);
    const Cover cover = resolver.cover(surfaces, assignment.coverage);
    const Image mean = resolver.mean(Image(kSamples, kSamples, 3, 2.0f), assignment.coverage);
    int partial = 0;
    for (int p = 0; p < kPixels * kPixels; ++p) {
        int hit = 0, shaded = 0;
        for (int s = 0; s < kFactor * kFactor; ++s) {
            const int x = p % kPixels * kFactor + s % kFactor, y = p / kPixels * kFactor + s / kFactor;
            const size_t i = static_cast<size_t>(y) * kSamples + x;
            hit += surfaces.validity(i) != Validity::background, shaded += surfaces.validity(i) == Validity::valid;
        }
        partial += shaded > 0 && shaded < 16;
        EXPECT_NEAR(cover.overlay[p], shaded / 16.0, 1e-6);
        EXPECT_NEAR(cover.specular[p], hit ? double(shaded) / hit : 0.0, 1e-6);
        EXPECT_NEAR(mean.at(static_cast<size_t>(p))[0], shaded ? 2.0 : 0.0, 1e-6);
    }
    EXPECT_GT(partial, 8);
}

TEST(Resolve, OwnSamplesAreCountedOnce) {
    const RandomSamples samples;
    Image numbers(kSamples, kSamples, 1, 3.0f);
    *numbers.at(5, 9) = 1.0f;
    const Resolver resolver({kFactor, 0, 0}, kWide, kFine, kFrame);
    const Image sum = resolver.sum(numbers), least = resolver.least(numbers, 7.0f);
    for (int y = 0; y < kPixels; ++y)
        for (int x = 0; x < kPixels; ++x) {
            const bool is_there = x == 1 && y == 2;
            EXPECT_EQ(*sum.at(x, y), is_there ? 46.0f : 48.0f);
            EXPECT_EQ(*least.at(x, y), is_there ? 1.0f : 3.0f);
        }
}

TEST(Resolve, PartsOfTheFrameAreThePixelsOfTheWhole) {
    const RandomSamples samples;
    const Image whole = Resolver({kFactor, 0, 0}, kWide, kFine, kFrame).mean(samples.overlay, samples.coverage);
    const Window part{0, 4 * kFactor - 6, kSamples, 3 * kFactor + 12};  // rows 4 to 6, and six samples of margin
    Image overlay(part.width, part.height, 3);
    std::copy_n(samples.overlay.at(0, part.y), overlay.data.size(), overlay.data.begin());
    const auto first = samples.coverage.begin() + part.y * kSamples;
    const PixelVector<float> coverage(first, first + part.height * kSamples);
    const Image rows = Resolver({kFactor, 0, 0}, kWide, part, {0, 4, kPixels, 3}).mean(overlay, coverage);
    EXPECT_TRUE(std::equal(rows.data.begin(), rows.data.end(), whole.at(0, 4)));
}

TEST(Resolve, WindowsMayDiffer) {
    const RandomSamples samples;
    const Image all = Resolver({kFactor, 0, 0}, kBox, kFine, kFrame).mean(samples.overlay, samples.coverage);
    // Two pixels of overscan around the frame, and display windows that begin elsewhere.
    const Image wide = Resolver({kFactor, 5, 7}, kBox, {5, 7, kSamples, kSamples}, {-2, -2, kPixels + 4, kPixels + 4})
                           .mean(samples.overlay, samples.coverage);
    for (int y = -2; y < kPixels + 2; ++y)
        for (int x = -2; x < kPixels + 2; ++x) {
            const bool inside = x >= 0 && y >= 0 && x < kPixels && y < kPixels;
            EXPECT_EQ(wide.at(x + 2, y + 2)[1], inside ? all.at(x, y)[1] : 0.0f);
        }
}

TEST(SampleGrid, FindsFactorAndOrigin) {
    const AovFrame frame = frame_with({10, 20, 100, 50}, {0, 10, 120, 70}, "beauty.exr");
    const SampleGrid grid = sample_grid(frame, frame_with({30, 40, 400, 200}, {30, 40, 100, 100}, "fine.exr"));
    EXPECT_EQ(grid.factor, 4);
    EXPECT_EQ(grid.samples_of({10, 20, 100, 50}), (Window{30, 40, 400, 200}));
}

TEST(SampleGrid, SaysWhatDoesNotFit) {
    const AovFrame frame = frame_with({0, 0, 100, 50}, {0, 0, 100, 50}, "beauty.exr");
    const auto message = [&](const Window& display, const Window& data) {
        try {
            const AovFrame fine = frame_with(display, data, "fine.exr");
            check_samples(sample_grid(frame, fine), frame, fine);
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ErrorCode::size_mismatch);
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    const std::string odd = message({0, 0, 250, 125}, {0, 0, 250, 125});
    EXPECT_NE(odd.find("fine.exr is 250x125, beauty.exr is 100x50"), std::string::npos) << odd;
    EXPECT_NE(odd.find("200x100 or 400x200"), std::string::npos) << odd;
    EXPECT_NE(message({0, 0, 200, 50}, {0, 0, 200, 50}).find("whole multiple"), std::string::npos);
    EXPECT_NE(message({0, 0, 50, 25}, {0, 0, 50, 25}).find("whole multiple"), std::string::npos);
    EXPECT_NE(message({0, 0, 200, 100}, {300, 0, 20, 20}).find("same crop"), std::string::npos);
    EXPECT_EQ(message({0, 0, 200, 100}, {150, 0, 100, 20}), "accepted");
}

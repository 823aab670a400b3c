#include <burnish/frequency/lobe_window.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr float kNarrowest = 5e-4f, kWidest = 0.5f * kPi;  // half widths, rad
constexpr float kDeviations = 2.5f;
constexpr float kMostShrunk = 0.25f;  // in one step: what is thinner than the samples is not measured yet
constexpr float kSettled = 0.03f;     // relative change of a window that has arrived
constexpr int kSteps = 60;    // an even light widens a window by 2.5 / sqrt 3 a step: 23 from the narrowest to the widest
constexpr int kSamples = 16;  // a side

/// Of value^2 over the window, in radian along its axes.
struct Moments {
    double energy = 0, x = 0, y = 0, xx = 0, xy = 0, yy = 0;

    Moments(const std::function<float(const Vec3f&)>& value, const LobeWindow& window) {
        const double a = window.along.length(), b = window.across.length();
        for (int i = 0; i < kSamples * kSamples; ++i) {
            const auto at = [](int k) { return (2.0f * static_cast<float>(k) + 1.0f) / kSamples - 1.0f; };
            const float u = at(i % kSamples), v = at(i / kSamples);
            const double f = value(window.direction(u, v)), weight = f * f, px = a * u, py = b * v;
            energy += weight, x += weight * px, y += weight * py;
            xx += weight * px * px, xy += weight * px * py, yy += weight * py * py;
        }
        if (!(energy > 0.0)) return;
        x /= energy, y /= energy;
        xx = xx / energy - x * x, xy = xy / energy - x * y, yy = yy / energy - y * y;
    }
};

LobeWindow round_window(const Vec3f& centre, float half_width) {
    const Frame frame = Frame::around(centre);
    return {centre, frame.t * half_width, frame.b * half_width};
}

/// The window around the ellipse that the moments describe.
LobeWindow moved(const LobeWindow& from, const Moments& m) {
    const float a = from.along.length(), b = from.across.length();
    const double turn = 0.5 * std::atan2(2.0 * m.xy, m.xx - m.yy), mean = 0.5 * (m.xx + m.yy);
    const double spread = std::hypot(0.5 * (m.xx - m.yy), m.xy);
    const float least = std::max(kNarrowest, kMostShrunk * std::min(a, b));
    const auto half_width = [&](double variance) {
        return static_cast<float>(std::clamp(kDeviations * std::sqrt(std::max(0.0, variance)), double{least}, double{kWidest}));
    };
    const Vec3f centre = from.direction(static_cast<float>(m.x) / a, static_cast<float>(m.y) / b);
    const Frame frame = Frame::along(
        centre, from.along / a * static_cast<float>(std::cos(turn)) + from.across / b * static_cast<float>(std::sin(turn)));
    return {centre, frame.t * half_width(mean + spread), frame.b * half_width(mean - spread)};
}

bool settled(const LobeWindow& before, const LobeWindow& after) {
    const float width = after.across.length();
    const auto close = [&](const Vec3f& p, const Vec3f& q) { return std::fabs(p.length() / q.length() - 1.0f) < kSettled; };
    return close(before.along, after.along) && close(before.across, after.across) &&
           (before.centre - after.centre).length() < kSettled * width;
}

}  // namespace

Vec3f LobeWindow::direction(float x, float y) const {
    const Vec3f step = along * x + across * y;
    const float angle = step.length();
    if (!(angle > 0.0f)) return centre;
    return centre * std::cos(angle) + step * (std::sin(angle) / angle);
}

Vec2f LobeWindow::place(const Vec3f& w) const {
    const float cosine = w.dot(centre), sine = (w - centre * cosine).length();
    const float angle_by_sine = sine > 0.0f ? std::atan2(sine, cosine) / sine : 1.0f;
    return {w.dot(along) / along.length2() * angle_by_sine, w.dot(across) / across.length2() * angle_by_sine};
}

float LobeWindow::stretch(float x, float y) const {
    const float angle = (along * x + across * y).length();
    const float round = angle > 0.0f ? angle / std::sin(angle) : 1.0f;
    return round / std::min(along.length(), across.length());
}

LobeWindow lobe_window(const std::function<float(const Vec3f& wi)>& value, const Vec3f& guess) {
    float half_width = kNarrowest;
    LobeWindow window = round_window(guess, half_width);
    for (int step = 0; step < kSteps; ++step) {
        const Moments moments(value, window);
        if (!(moments.energy > 0.0)) {
            if (half_width >= kWidest) break;
            half_width = std::min(2.0f * half_width, kWidest);
            window = round_window(guess, half_width);
            continue;
        }
        const LobeWindow next = moved(window, moments);
        if (settled(window, next)) return next;
        window = next;
    }
    return window;
}

}  // namespace burnish

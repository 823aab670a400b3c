// Which error a factorisation makes least: a residual per channel, and what it counts for.
#pragma once

#include <burnish/base/display.h>
#include <burnish/factor/factorise.h>
#include <burnish/factor/sample_lookups.h>

namespace burnish {

class MeasuredResidual {
public:
    /// `mean`: of the samples, per channel; `bias`: of the mean, added to what errors are relative to.
    MeasuredResidual(FactorMeasure measure, const ColorRow& mean, float bias)
        : m_measure(measure),
          m_floor(mean * bias),
          m_white(mean.sum() > 0 ? mean.sum() / 3 / static_cast<float>(kMiddleGrey) : 1) {}

    struct Value {
        ColorRow residual, slope;  // slope: the residual's derivative by `is`
    };

    Value operator()(const ColorRow& is, const ColorRow& should_be) const {
        if (m_measure == FactorMeasure::absolute) return {is - should_be, ColorRow::Ones()};
        if (m_measure == FactorMeasure::display) return displayed(is, should_be);
        const ColorRow size = should_be + m_floor, slope = (size > 0).select(size.inverse(), 0.0f);
        return {(is - should_be) * slope, slope};
    }

    /// What is summed over samples: the square, of relative errors nearly the residual itself.
    ColorRow loss(const ColorRow& residual) const {
        if (m_measure != FactorMeasure::relative) return residual.square();
        return 2 * ((residual.square() + kRound * kRound).sqrt() - kRound);
    }

    /// What squares of residuals about this one have to be weighed with to fall as the loss does.
    ColorRow weight(const ColorRow& residual) const {
        if (m_measure != FactorMeasure::relative) return ColorRow::Ones();
        return (residual.square() + kRound * kRound).rsqrt();
    }

private:
    static constexpr float kRound = 0.02f;  // relative errors below count by their squares

    Value displayed(const ColorRow& is, const ColorRow& should_be) const {
        Value value{ColorRow::Zero(), ColorRow::Zero()};
        for (int channel = 0; channel < 3; ++channel) {
            const float shown = is[channel] / m_white;
            value.residual[channel] = encoded(shown) - encoded(should_be[channel] / m_white);
            value.slope[channel] = slope(shown) / m_white;
        }
        return value;
    }

    /// The display's curve, straight below black. Beyond white it goes on as a flat logarithm, so that what is white stays bounded.
    static float encoded(float x) {
        if (x <= 0.0031308f) return 12.92f * x;
        return x < 1 ? 1.055f * std::pow(x, 1 / 2.4f) - 0.055f : 1 + kBeyondWhite * std::log(x);
    }
    static float slope(float x) {
        if (x <= 0.0031308f) return 12.92f;
        return x < 1 ? 1.055f / 2.4f * std::pow(x, 1 / 2.4f - 1) : kBeyondWhite / x;
    }
    static constexpr float kBeyondWhite = 0.05f;

    FactorMeasure m_measure;
    ColorRow m_floor;
    float m_white;
};

}  // namespace burnish

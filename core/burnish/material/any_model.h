// A model behind a pointer: one type for all the models that kernels are not compiled for (see lobe.h).
//
// Calls are virtual, which costs a nanosecond a sample; few-sample estimators tabulate a lobe once and never notice.
#pragma once

#include <burnish/material/model.h>

#include <memory>

namespace burnish {

class AnyModel {
public:
    /// The model of p.model, whichever of models.def it is.
    explicit AnyModel(const LobeParameters& p);

    AnyModel with_widths(float mx, float my) const;
    /// Seen through Gaussian slopes: the model of widths sqrt(m^2 + variance), or what it says itself where stretched slopes will not do.
    AnyModel blurred(const Vec2f& variance) const;
    Color3f eval(const Vec3f& wo, const Vec3f& wi) const { return m_model->eval(wo, wi); }
    float pdf(const Vec3f& wo, const Vec3f& wi) const { return m_model->pdf(wo, wi); }
    Vec3f sample(const Vec3f& wo, const Vec2f& u) const { return m_model->sample(wo, u); }
    float D(const Vec3f& wm) const { return m_model->D(wm); }
    float border(float xi) const { return m_model->border(xi); }

    /// Of models with `ModelInfo::own_width`: the slope width at which they are not stretched; else 0.
    float own_width() const { return m_model->own_width(); }
    /// What the model made from its numbers or shows, null where it has nothing of the kind.
    std::shared_ptr<const LobeData> data() const { return m_model->data(); }

    /// What is behind the pointer: the methods of `LobeKernel`.
    struct Interface {
        virtual ~Interface() = default;
        virtual std::shared_ptr<const Interface> with_widths(float mx, float my) const = 0;
        virtual std::shared_ptr<const Interface> blurred(const Vec2f& variance) const = 0;  // null: by its widths
        virtual Color3f eval(const Vec3f& wo, const Vec3f& wi) const = 0;
        virtual float pdf(const Vec3f& wo, const Vec3f& wi) const = 0;
        virtual Vec3f sample(const Vec3f& wo, const Vec2f& u) const = 0;
        virtual float D(const Vec3f& wm) const = 0;
        virtual float border(float xi) const = 0;
        virtual float own_width() const = 0;
        virtual std::shared_ptr<const LobeData> data() const = 0;
    };

private:
    AnyModel(std::shared_ptr<const Interface> model, float mx, float my);

    std::shared_ptr<const Interface> m_model;
    float m_mx, m_my;
};

/// Makes what the lobe's model computes once, so that copies of the lobe need not. Models are the same without it, but slower to
/// build. Returns the model's own width, 0 where it has none.
float prepare(LobeParameters& lobe);

}  // namespace burnish

#include <burnish/material/any_model.h>
#include <burnish/material/models/all.h>

namespace burnish {
namespace {

template <LobeModel M>
struct Held final : AnyModel::Interface {
    M model;

    explicit Held(const M& own) : model(own) {}

    std::shared_ptr<const Interface> with_widths(float mx, float my) const override {
        return std::make_shared<Held>(model.with_widths(mx, my));
    }
    std::shared_ptr<const Interface> blurred(const Vec2f& variance) const override {
        if constexpr (requires { model.blurred(variance); }) return std::make_shared<Held>(model.blurred(variance));
        return nullptr;
    }
    Color3f eval(const Vec3f& wo, const Vec3f& wi) const override { return model.eval(wo, wi); }
    float pdf(const Vec3f& wo, const Vec3f& wi) const override { return model.pdf(wo, wi); }
    Vec3f sample(const Vec3f& wo, const Vec2f& u) const override { return model.sample(wo, u); }
    float D(const Vec3f& wm) const override { return model.D(wm); }
    float border(float xi) const override { return model.border(xi); }
    float own_width() const override {
        if constexpr (requires { model.own_width(); }) return model.own_width();
        return 0;
    }
    std::shared_ptr<const LobeData> data() const override {
        if constexpr (requires { model.data(); }) return model.data();
        return nullptr;
    }
};

std::shared_ptr<const AnyModel::Interface> held(const LobeParameters& p) {
    switch (p.model) {
#define BURNISH_MODEL(id, type) \
    case ModelId::id:           \
        return std::make_shared<Held<type>>(type(p));
#include <burnish/material/models/models.def>
#undef BURNISH_MODEL
    }
    return std::make_shared<Held<Kurt>>(Kurt(p));
}

}  // namespace

AnyModel::AnyModel(const LobeParameters& p) : AnyModel(held(p), p.mx, p.my) {}

AnyModel::AnyModel(std::shared_ptr<const Interface> model, float mx, float my)
    : m_model(std::move(model)), m_mx(mx), m_my(my) {}

AnyModel AnyModel::with_widths(float mx, float my) const {
    return mx == m_mx && my == m_my ? *this : AnyModel(m_model->with_widths(mx, my), mx, my);
}

AnyModel AnyModel::blurred(const Vec2f& variance) const {
    const float mx = std::sqrt(m_mx * m_mx + variance.x), my = std::sqrt(m_my * m_my + variance.y);
    const std::shared_ptr<const Interface> own = m_model->blurred(variance);
    return own ? AnyModel(own, mx, my) : with_widths(mx, my);
}

float prepare(LobeParameters& lobe) {
    if (!model_info(lobe.model).own_width) return 0;
    const AnyModel model(lobe);
    lobe.data = model.data();
    return model.own_width();
}

}  // namespace burnish

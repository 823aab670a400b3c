#include <burnish/job/make_factors.h>

#include <burnish/base/error.h>
#include <burnish/base/json_text.h>
#include <burnish/base/parallel.h>
#include <burnish/factor/brdf_samples.h>
#include <burnish/factor/decompose.h>
#include <burnish/factor/glsl.h>
#include <burnish/factor/prescale_search.h>
#include <burnish/job/color_flow.h>
#include <burnish/job/lighting_check.h>
#include <burnish/job/look.h>
#include <burnish/job/stages.h>
#include <burnish/material/library.h>
#include <burnish/material/material_brdf.h>
#include <burnish/material/measured/read_measured.h>
#include <burnish/output/exr_writer.h>
#include <burnish/output/factors_writer.h>

#include <nlohmann/json.hpp>

#include <filesystem>

namespace burnish {
namespace {

using nlohmann::json;

Material material_of(const std::string& text) {
    return text.starts_with('{') ? material_from_json(parse_json(text, "material"), "material", "material")
                                 : find_material(text);
}

const Parametrization& parametrization_of(const FactorJob& job, FactoredFunction of) {
    const bool is_brdf = of == FactoredFunction::brdf;
    const Parametrization& chosen = parametrization_by_name(!job.parametrization.empty() ? job.parametrization
                                                            : is_brdf                    ? "pqp"
                                                                                         : "nre");
    if (chosen.of == of) return chosen;
    throw Error(ErrorCode::bad_argument,
                "parametrisation " + chosen.name +
                    (is_brdf ? " factors lighting; name an environment with env" : " factors BRDFs; leave out env"));
}

json error_to_json(const FactorError& error) {
    return {{"average_absolute", error.average_absolute},
            {"max_absolute", error.max_absolute},
            {"average_relative", error.average_relative},
            {"max_relative", error.max_relative},
            {"rms", error.rms}};
}

/// A job on its way: what every stage needs of those before it.
class Factoring {
public:
    Factoring(const FactorJob& job, std::shared_ptr<const Environment> light, const Progress& progress)
        : m_job(job), m_material(material_of(job.material)), m_light(std::move(light)), m_progress(progress) {}

    FactorReport run() {
        if (!m_light && !m_job.scene.environment.empty())
            m_light = timed(m_report.seconds, "light",
                            [&] { return load_light(m_job.scene, ColorFlow(m_job.scene), Renderer::unknown); });
        const Parametrization& parametrization =
            parametrization_of(m_job, m_light ? FactoredFunction::lighting : FactoredFunction::brdf);
        m_samples = timed(m_report.seconds, "sample", [&] { return sample(parametrization); });
        m_report.samples = m_samples.size();
        m_report.stored.factors = timed(m_report.seconds, "factor", [&] { return factor(parametrization); });
        timed(m_report.seconds, "check", [&] { check(); });
        timed(m_report.seconds, "write", [&] { write(); });
        return std::move(m_report);
    }

private:
    Progress part(float begin, float end) const { return part_of(m_progress, begin, end); }

    /// Of a BRDF: f(wi, wo).
    PairFunction brdf() const {
        return [f = MaterialBrdf(m_material)](const DirectionPair& pair) { return f(pair.b, pair.a); };
    }

    std::vector<FactorSample> sample(const Parametrization& parametrization) {
        if (!m_light && is_measured_name(m_job.material)) return measured_samples(*read_measured(m_job.material));
        if (!m_light) return brdf_samples(parametrization, brdf(), {.size = m_job.grid});
        m_report.stored.world_to_map = m_light->world_to_light(), m_report.stored.gain = m_light->gain();
        m_guide = FactorGuide::of(m_material);
        m_guide.dominant = dominant_direction(*m_light);
        const LightingSampling sampling{m_job.grid, m_job.weight, m_job.scene.estimator};
        return lighting_samples(m_material, *m_light, sampling, part(0, 0.3f));
    }

    Factors factor(const Parametrization& parametrization) const {
        if (m_job.method != FactorMethod::homomorphic) return decomposed(parametrization);
        FactoriseSettings maps = m_job.maps;
        maps.measure = m_job.measure.value_or(m_light ? FactorMeasure::display : FactorMeasure::relative);
        return factorise(parametrization, m_samples, m_guide, maps, part(0.3f, 0.8f));
    }

    Factors decomposed(const Parametrization& parametrization) const {
        if (m_light)
            throw Error(ErrorCode::bad_argument,
                        "methods svd and normalised factor BRDFs; leave out env, or take the method homomorphic");
        const bool is_svd = m_job.method == FactorMethod::svd;
        const DecomposeSettings settings{is_svd ? Decomposition::svd : Decomposition::normalised, m_job.maps.size,
                                         std::max(m_job.maps.terms, 1)};
        return decompose(parametrization, brdf(), settings, part(0.3f, 0.8f));
    }

    void check() {
        constexpr int kPairs = 400;
        m_report.error = factor_error(m_report.stored.factors, m_samples, m_job.maps.bias);
        if (m_light)
            m_report.display_psnr_db = lighting_psnr_db(m_report.stored, m_material, *m_light, kPairs, part(0.8f, 0.95f));
        if (m_job.png.empty()) return;
        m_report.pictures =
            quantise(m_report.stored.factors, best_prescale(m_report.stored.factors, m_job.eight_bit, m_samples));
        m_report.picture_error = factor_error(*m_report.pictures, m_samples, m_job.maps.bias);
    }

    json made_of() const {
        json made_of = {{"material", material_to_json(m_material)},
                        {"samples", m_samples.size()},
                        {"error", error_to_json(m_report.error)}};
        if (!m_material.name.empty()) made_of["material_name"] = m_material.name;
        if (!m_job.scene.environment.empty()) made_of["environment"] = m_job.scene.environment;
        if (m_report.display_psnr_db) made_of["display_psnr_db"] = *m_report.display_psnr_db;
        return made_of;
    }

    void write() {
        StoredFactors& stored = m_report.stored;
        stored.made_of = made_of().dump();
        if (!m_job.output.empty()) {
            write_factors(m_job.output, stored);
            m_report.files.push_back(m_job.output);
        }
        if (!m_job.glsl.empty()) write_shader(m_job.glsl, glsl_of(stored));
        if (m_report.pictures) write_pictures();
        m_progress.report("write", 1);
    }

    void write_shader(const std::string& file, const std::string& text) {
        write_text(file, text);
        m_report.files.push_back(file);
    }

    void write_pictures() {
        const std::string stem = std::filesystem::path(m_job.output).stem().string(), name = stem.empty() ? "factors" : stem;
        for (const std::string& file : write_quantised(m_job.png, name, m_report.stored, *m_report.pictures))
            m_report.files.push_back(file);
        write_shader((std::filesystem::path(m_job.png) / (name + ".glsl")).string(),
                     glsl_of(m_report.stored, *m_report.pictures));
    }

    const FactorJob& m_job;
    Material m_material;
    std::shared_ptr<const Environment> m_light;
    const Progress& m_progress;
    FactorGuide m_guide;
    std::vector<FactorSample> m_samples;
    FactorReport m_report;
};

}  // namespace

FactorReport make_factors(const FactorJob& job, std::shared_ptr<const Environment> light, const Progress& progress) {
    const ThreadLimit limit(job.scene.threads);
    return Factoring(job, std::move(light), progress).run();
}

json factor_report_to_json(const FactorReport& report) {
    json seconds = json::object();
    for (const auto& [stage, elapsed] : report.seconds) seconds[stage] = elapsed;
    json result = {{"parametrization", report.stored.factors.parametrization->name},
                   {"terms", report.stored.factors.terms.size()},
                   {"samples", report.samples},
                   {"error", error_to_json(report.error)},
                   {"seconds", seconds},
                   {"files", report.files}};
    if (report.picture_error) result["eight_bit_error"] = error_to_json(*report.picture_error);
    if (report.pictures) result["eight_bit"] = eight_bit_to_json(*report.pictures);
    if (report.display_psnr_db) result["display_psnr_db"] = *report.display_psnr_db;
    return result;
}

}  // namespace burnish

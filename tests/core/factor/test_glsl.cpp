// The GLSL of factors, taken by the reference compiler.
#include "core/scratch.h"

#include <burnish/factor/glsl.h>

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>

namespace burnish {
namespace {

StoredFactors uniform_stored(const Parametrization& parametrization, Mapping sphere, size_t terms) {
    StoredFactors stored;
    stored.factors = uniform_factors(parametrization, sphere, 8, Color3f(0.5f));
    stored.factors.terms.resize(terms, stored.factors.terms[0]);
    return stored;
}

/// What the compiler prints and whether it was content.
std::pair<std::string, bool> output_of(const std::string& command) {
    std::string text;
    FILE* pipe = popen((command + " 2>&1").c_str(), "r");
    for (char line[256]; std::fgets(line, sizeof line, pipe);) text += line;
    return {text, pclose(pipe) == 0};
}

class Shaders {
public:
    void add(const std::string& name, const StoredFactors& stored, const std::string& snippet) {
        const std::string file = m_scratch.file(name + ".frag");
        const char* first = stored.factors.parametrization->of == FactoredFunction::brdf ? "wi" : "n";
        std::ofstream(file) << "#version 330 core\n"
                            << snippet << "in vec3 " << first << ", wo;\nout vec4 color;\n"
                            << "void main() { color = vec4(burnish_factored(" << first << ", wo), 1.0); }\n";
        m_files += " " + file;
    }
    const std::string& files() const { return m_files; }

private:
    Scratch m_scratch;
    std::string m_files;
};

TEST(Glsl, Compiles) {
    if (!output_of("glslangValidator --version").second) GTEST_SKIP() << "there is no glslangValidator (Debian: glslang-tools)";
    Shaders shaders;
    for (const Parametrization& parametrization : parametrizations())
        for (const Mapping sphere : {Mapping::double_parabolic, Mapping::cube}) {
            const std::string name = parametrization.name + "_" + std::string(mapping_name(sphere));
            for (const size_t terms : {1, 3}) {
                const StoredFactors stored = uniform_stored(parametrization, sphere, terms);
                shaders.add(name + "_" + std::to_string(terms), stored, glsl_of(stored));
                const QuantisedFactors eight_bit = quantise(stored.factors, QuantiseSettings());
                shaders.add(name + "_8_bit_" + std::to_string(terms), stored, glsl_of(stored, eight_bit));
            }
        }
    StoredFactors hemispherical = uniform_stored(parametrization_by_name("hd"), Mapping::cube, 1);
    const DirectionMap disc(Mapping::hemispherical, 8);
    for (FactorMap& map : hemispherical.factors.terms[0]) map = {disc, std::vector<Color3f>(disc.texels(), Color3f(1))};
    shaders.add("hemispherical", hemispherical, glsl_of(hemispherical));
    const auto [text, is_content] = output_of("glslangValidator" + shaders.files());
    EXPECT_TRUE(is_content) << text;
}

TEST(Glsl, WritesNumbersAsFloats) {
    StoredFactors stored = uniform_stored(parametrization_by_name("nrhd"), Mapping::cube, 1);
    stored.gain = Color3f(1e10f, 0.25f, 3);
    EXPECT_NE(glsl_of(stored).find("burnish_gain = vec3(1e+10, 0.25, 3.0)"), std::string::npos);
    EXPECT_NE(glsl_of(stored).find("dominant = vec3(0.0, 0.0, 1.0)"), std::string::npos);
}

}  // namespace
}  // namespace burnish

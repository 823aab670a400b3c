#include <burnish/base/atomic_file.h>
#include <burnish/material/measured/gonio_file.h>
#include <burnish/material/measured/gonio_pairs.h>
#include <burnish/material/measured/number_text.h>

#include <algorithm>

namespace burnish {
namespace {

constexpr std::string_view kMagic = "# burnish gonio 1";
constexpr double kDegree = std::numbers::pi / 180;

/// What the lines that begin with # say.
struct Header {
    std::string surface, values;
    size_t values_in_row = 0;  // 1 or 3
};

std::string rest_of(const std::vector<std::string_view>& line) {
    std::string text;
    for (size_t i = 2; i < line.size(); ++i) text += (i > 2 ? " " : "") + std::string(line[i]);
    return text;
}

Header read_header(const NumberText& text) {
    Header header;
    for (const NumberText::Line& line : text.lines()) {
        const std::vector<std::string_view> words = burnish::words(line.text);
        if (words.size() < 2 || words[0] != "#") continue;
        if (words[1] == "surface") header.surface = rest_of(words);
        if (words[1] == "values") header.values = rest_of(words);
        if (words[1] != "columns") continue;
        const std::string columns = rest_of(words), angles = "theta_i phi_i theta_o phi_o ";
        header.values_in_row = columns == angles + "R G B" ? 3 : columns == angles + "value" ? 1 : 0;
    }
    if (header.surface != "isotropic" && header.surface != "anisotropic")
        text.refuse("expected a line \"# surface isotropic\" or \"# surface anisotropic\"");
    if (header.values != "brdf" && header.values != "transfer")
        text.refuse("expected a line \"# values brdf\" (f in 1/sr) or \"# values transfer\" (f |cos theta_o|)");
    if (header.values_in_row == 0)
        text.refuse("expected a line \"# columns theta_i phi_i theta_o phi_o R G B\" or \"... phi_o value\"");
    return header;
}

GonioRow read_row(const NumberText& text, const NumberText::Line& line, const Header& header) {
    const std::vector<double> row = text.numbers(line);
    if (row.size() != 4 + header.values_in_row)
        text.refuse(line,
                    "expected " + std::to_string(4 + header.values_in_row) + " numbers, found " + std::to_string(row.size()));
    if (!(row[0] >= 0 && row[0] < 90))
        text.refuse(line, "expected theta_i in [0, 90) degrees, found " + std::to_string(row[0]));
    if (!(row[2] >= 0 && row[2] <= 180))
        text.refuse(line, "expected theta_o in [0, 180] degrees, found " + std::to_string(row[2]));
    const bool grey = header.values_in_row == 1;
    const auto value = [&](size_t c) { return static_cast<float>(row[grey ? 4 : 4 + c]); };
    return {row[0] * kDegree, row[1] * kDegree, row[2] * kDegree, row[3] * kDegree, {value(0), value(1), value(2)}};
}

}  // namespace

bool is_gonio_file(const std::string& first_line) { return first_line.starts_with(kMagic); }

std::shared_ptr<const GonioTable> read_gonio(const std::string& file) {
    const NumberText text(file);
    const Header header = read_header(text);
    std::vector<BrdfSample> samples;
    for (const NumberText::Line& line : text.lines()) {
        if (line.text.starts_with('#')) continue;
        if (const auto sample = gonio_sample(read_row(text, line, header), header.values == "transfer"))
            samples.push_back(*sample);
    }
    if (samples.empty()) text.refuse("no row is more than half a degree above the horizon");
    auto table = std::make_shared<GonioTable>(std::move(samples), header.surface == "isotropic");
    table->set_file(file);
    return table;
}

void write_gonio(const std::vector<BrdfSample>& samples, bool isotropic, const std::string& file) {
    AtomicFile target(file);
    std::fprintf(target.handle(), "%s\n# surface %s\n# values brdf\n# columns theta_i phi_i theta_o phi_o R G B\n",
                 std::string(kMagic).c_str(), isotropic ? "isotropic" : "anisotropic");
    const auto theta = [](const Vec3f& w) { return std::atan2(std::hypot(double(w.x), double(w.y)), double(w.z)) / kDegree; };
    const auto phi = [](const Vec3f& w) { return std::atan2(double(w.y), double(w.x)) / kDegree; };
    for (const BrdfSample& s : samples) {
        const Vec3f incident = s.wi.z < 0 ? s.wo : s.wi, outgoing = s.wi.z < 0 ? s.wi : s.wo;
        std::fprintf(target.handle(), "%.9g %.9g %.9g %.9g %.9g %.9g %.9g\n", theta(incident), phi(incident), theta(outgoing),
                     phi(outgoing), s.f.x, s.f.y, s.f.z);
    }
    target.commit();
}

}  // namespace burnish

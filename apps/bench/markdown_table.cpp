#include "markdown_table.h"

#include "result_text.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace {

std::string rowOf(const std::vector<std::string>& cells) {
    std::string row = "|";
    for (const std::string& cell : cells) {
        row += ' ';
        row += cell;
        row += " |";
    }
    return row + "\n";
}

std::string scientificText(double value) {
    std::ostringstream text;
    text << std::scientific << std::setprecision(1) << value;
    return text.str();
}

}  // namespace

std::optional<double> ceilingShare(const Result& result, const std::optional<Ceiling>& ceiling) {
    if (!ceiling || ceiling->error || !isCandela(result) || result.tileBackend == "cpu") return std::nullopt;
    if (!result.pairsLit || result.lighting.value_or(0.0) <= 0.0) return std::nullopt;
    return static_cast<double>(*result.pairsLit) / (*result.lighting * 1.0e-3) / ceiling->pairsPerSecond;
}

std::string markdownTable(const std::vector<Result>& results, const std::optional<Ceiling>& ceiling) {
    std::vector<std::string> heading{"scene",    "lights",  "technique", "frame ms", "geometry",
                                     "lighting", "display", "lit M",     "lit %",    "M lit/s"};
    std::string rule = "| --- | ---: | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: |";
    if (ceiling) {
        heading.emplace_back("% of ceiling");
        rule += " ---: |";
    }
    const bool compared =
        std::ranges::any_of(results, [](const Result& r) { return r.difference.has_value(); });
    if (compared) {
        heading.emplace_back("difference");
        rule += " ---: |";
    }
    std::string table = rowOf(heading) + rule + "\n", failures;
    for (const Result& r : results) {
        const std::string lights = std::to_string(r.lights);
        if (r.error) {
            failures += "\n" + r.scene + ", " + lights + " lights, " + rowName(r) +
                        ": not measured: " + *r.error + "\n";
            continue;
        }
        std::vector<std::string> cells{r.scene,
                                       lights,
                                       rowName(r),
                                       fixedText(r.frame, 2),
                                       fixedText(r.geometry, 2),
                                       fixedText(r.lighting, 2),
                                       fixedText(r.display, 2),
                                       millionsText(r.pairsLit),
                                       shareText(r),
                                       rateText(r)};
        if (ceiling) {
            const std::optional<double> share = ceilingShare(r, ceiling);
            cells.push_back(share ? fixedText(100.0 * *share, 1) : "-");
        }
        if (compared) cells.push_back(r.difference ? scientificText(r.difference->mean) : "-");
        table += rowOf(cells);
    }
    return table + failures;
}

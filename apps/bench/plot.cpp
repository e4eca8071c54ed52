#include "results.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace {

constexpr double width = 760, height = 460, left = 80, right = 180, top = 50, bottom = 60;

/// A logarithmic axis that spans whole decades.
class LogAxis {
  public:
    LogAxis(double min, double max, double from, double to)
        : first_(std::floor(std::log10(min))),
          last_(std::max(std::ceil(std::log10(max)), first_ + 1.0)),
          from_(from),
          to_(to) {}

    double at(double value) const {
        return from_ + (std::log10(value) - first_) / (last_ - first_) * (to_ - from_);
    }
    std::vector<double> decades() const {
        std::vector<double> values;
        for (double exponent = first_; exponent <= last_; exponent += 1.0)
            values.push_back(std::pow(10.0, exponent));
        return values;
    }

  private:
    double first_, last_, from_, to_;
};

struct Line {
    std::string name;
    std::vector<std::pair<double, double>>
        points;  ///< Lights and milliseconds, in ascending order of lights.
};

std::vector<Line> linesOf(const std::vector<Result>& results) {
    std::vector<Line> lines;
    for (const Result& result : results) {
        if (!result.lighting || result.lights == 0 || *result.lighting <= 0.0) continue;
        const std::string name = rowName(result);
        auto line = std::ranges::find(lines, name, &Line::name);
        if (line == lines.end()) line = lines.insert(lines.end(), {name, {}});
        line->points.emplace_back(static_cast<double>(result.lights), *result.lighting);
    }
    for (Line& line : lines) std::ranges::sort(line.points);
    return lines;
}

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text)
        result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
    return result;
}

std::string label(double value) {
    std::ostringstream text;
    text << std::defaultfloat << value;
    return text.str();
}

}  // namespace

std::string plotSvg(const std::string& renderer, const std::vector<Result>& results) {
    const std::vector<Line> lines = linesOf(results);
    double minX = 1e30, maxX = 1.0, minY = 1e30, maxY = 1e-3;
    for (const Line& line : lines) {
        for (const auto& [x, y] : line.points) {
            minX = std::min(minX, x), maxX = std::max(maxX, x);
            minY = std::min(minY, y), maxY = std::max(maxY, y);
        }
    }
    const LogAxis xAxis(std::min(minX, maxX), maxX, left, width - right),
        yAxis(std::min(minY, maxY), maxY, height - bottom, top);
    std::ostringstream svg;
    svg << std::fixed << std::setprecision(1);
    svg << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width << "\" height=\"" << height
        << "\" font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" "
           "fill=\"white\"/>\n";
    svg << "<text x=\"" << left << "\" y=\"24\" font-size=\"14\">Lighting pass on " << escaped(renderer)
        << "</text>\n";
    for (const double x : xAxis.decades()) {
        svg << "<line x1=\"" << xAxis.at(x) << "\" y1=\"" << top << "\" x2=\"" << xAxis.at(x) << "\" y2=\""
            << height - bottom << "\" stroke=\"#ddd\"/><text x=\"" << xAxis.at(x) << "\" y=\""
            << height - bottom + 18 << "\" text-anchor=\"middle\">" << label(x) << "</text>\n";
    }
    for (const double y : yAxis.decades()) {
        svg << "<line x1=\"" << left << "\" y1=\"" << yAxis.at(y) << "\" x2=\"" << width - right << "\" y2=\""
            << yAxis.at(y) << "\" stroke=\"#ddd\"/><text x=\"" << left - 8 << "\" y=\"" << yAxis.at(y) + 4
            << "\" text-anchor=\"end\">" << label(y) << "</text>\n";
    }
    svg << "<text x=\"" << (left + width - right) / 2 << "\" y=\"" << height - 16
        << "\" text-anchor=\"middle\">lights</text>\n";
    svg << "<text transform=\"translate(22 " << (top + height - bottom) / 2
        << ") rotate(-90)\" text-anchor=\"middle\">milliseconds</text>\n";
    constexpr std::array colors{"#0b6e99", "#d9480f", "#5c940d", "#862e9c", "#c2255c", "#495057"};
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const char* color = colors[i % colors.size()];
        svg << "<polyline fill=\"none\" stroke=\"" << color << "\" stroke-width=\"2\" points=\"";
        for (const auto& [x, y] : lines[i].points) svg << xAxis.at(x) << ',' << yAxis.at(y) << ' ';
        svg << "\"/>\n";
        for (const auto& [x, y] : lines[i].points) {
            svg << "<circle cx=\"" << xAxis.at(x) << "\" cy=\"" << yAxis.at(y) << "\" r=\"3\" fill=\""
                << color << "\"/>\n";
        }
        const double row = top + 10 + 20.0 * static_cast<double>(i);
        svg << "<line x1=\"" << width - right + 16 << "\" y1=\"" << row << "\" x2=\"" << width - right + 40
            << "\" y2=\"" << row << "\" stroke=\"" << color << "\" stroke-width=\"2\"/><text x=\""
            << width - right + 46 << "\" y=\"" << row + 4 << "\">" << escaped(lines[i].name) << "</text>\n";
    }
    svg << "</svg>\n";
    return svg.str();
}

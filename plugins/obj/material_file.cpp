#include "material_file.h"

#include <unordered_map>

#include "lines.h"

namespace candela_obj {
namespace {

class MaterialParser {
  public:
    MaterialParser(const std::string& file, std::vector<FileMaterial>& materials)
        : file_(file), materials_(materials) {}

    void read(Statement& statement) {
        const std::string_view keyword = statement.keyword();
        if (keyword == "newmtl") return begin(statement);
        if (isUnused(keyword)) return ignored_.count("not used", keyword, statement.line());
        const auto found = readers().find(keyword);
        if (found == readers().end()) return ignored_.count("not known", keyword, statement.line());
        if (!hasBegun_) statement.fail("no newmtl stands before it");
        (this->*found->second)(statement);
    }

    void note(const Host& host) const { ignored_.note(host, file_); }

  private:
    using Reader = void (MaterialParser::*)(Statement&);

    static const std::unordered_map<std::string_view, Reader>& readers() {
        using P = MaterialParser;
        static const std::unordered_map<std::string_view, Reader> table{
            {"Kd", &P::readColor<&FileMaterial::diffuse>},
            {"Ke", &P::readColor<&FileMaterial::emission>},
            {"Ns", &P::readExponent},
            {"d", &P::readOpacity},
            {"Tr", &P::readTransparency},
            {"Pr", &P::readShare<&FileMaterial::roughness>},
            {"Pm", &P::readShare<&FileMaterial::metallic>},
            {"map_Kd", &P::readMap<&FileMaterial::diffuseMap>},
            {"map_Ke", &P::readMap<&FileMaterial::emissionMap>},
            {"map_d", &P::readMap<&FileMaterial::opacityMap>},
            {"map_Pr", &P::readMap<&FileMaterial::roughnessMap>},
            {"map_Pm", &P::readMap<&FileMaterial::metallicMap>},
            {"norm", &P::readMap<&FileMaterial::normalMap>}};
        return table;
    }

    /// Known statements that this renderer has no use for. Of bump maps: they hold heights, not normals.
    static bool isUnused(std::string_view keyword) {
        static constexpr std::string_view unused[] = {
            "Ka",       "Ks",     "Tf",     "Ni",      "illum",   "sharpness", "Ps",
            "Pc",       "Pcr",    "aniso",  "anisor",  "map_Ka",  "map_Ks",    "map_Ns",
            "map_Tr",   "map_Ps", "map_Pc", "map_Pcr", "map_aat", "bump",      "map_bump",
            "map_Bump", "disp",   "decal",  "refl",    "map_refl"};
        for (const std::string_view known : unused)
            if (keyword == known) return true;
        return false;
    }

    void begin(Statement& statement) {
        materials_.emplace_back();
        materials_.back().name = statement.rest();
        materials_.back().element =
            statement.place() + ": newmtl '" + readable(std::string(statement.rest())) + "'";
        hasBegun_ = true;
    }

    template <std::optional<std::array<float, 3>> FileMaterial::*member>
    void readColor(Statement& statement) {
        if (statement.rest().starts_with("spectral") || statement.rest().starts_with("xyz"))
            return ignored_.count("not used", std::string(statement.keyword()) + " other than r g b",
                                  statement.line());
        // Emission has no upper limit but that of the host.
        const bool emits = member == &FileMaterial::emission;
        const double most = emits ? 1e20 : 1.0;
        std::array<float, 3> color{};
        color[0] = number(statement, statement.needWord("r g b"), most);
        // The format lets a single number stand for all three.
        color[1] = color[2] = color[0];
        if (const auto green = statement.word()) {
            color[1] = number(statement, *green, most);
            color[2] = number(statement, statement.needWord("r g b"), most);
        }
        materials_.back().*member = color;
    }

    /// From 0 to `most`.
    static float number(const Statement& statement, std::string_view word, double most) {
        const float value = statement.number(word, most);
        if (value < 0.0f) statement.fail("'" + std::string(word) + "', but 0 or more was expected");
        return value;
    }

    template <std::optional<float> FileMaterial::*member>
    void readShare(Statement& statement) {
        materials_.back().*member = number(statement, statement.needWord("a number"), 1.0);
    }

    void readExponent(Statement& statement) {
        constexpr double greatest = 1e30;
        materials_.back().exponent = number(statement, statement.needWord("a number"), greatest);
    }

    void readOpacity(Statement& statement) {
        if (statement.rest().starts_with("-halo")) {
            ignored_.count("not used", "option -halo of d", statement.line());
            statement.word();
        }
        readShare<&FileMaterial::opacity>(statement);
    }

    /// Where both are given, d counts.
    void readTransparency(Statement& statement) {
        const float transparency = number(statement, statement.needWord("a number"), 1.0);
        if (!materials_.back().opacity) materials_.back().opacity = 1.0f - transparency;
    }

    template <std::optional<TextureInfo> FileMaterial::*member>
    void readMap(Statement& statement) {
        materials_.back().*member = parseTextureInfo(statement, file_, ignored_);
    }

    const std::string& file_;
    std::vector<FileMaterial>& materials_;
    IgnoredStatements ignored_;
    bool hasBegun_ = false;
};

}  // namespace

void parseMaterialFile(const std::string& name, const Host& host, std::vector<FileMaterial>& materials) {
    const Bytes file = host.readFile(name);
    Lines lines({reinterpret_cast<const char*>(file.data), file.size});
    MaterialParser parser(name, materials);
    while (lines.next()) {
        Statement statement(lines.line(), lines.number(), name);
        parser.read(statement);
    }
    parser.note(host);
}

}  // namespace candela_obj

#include "farm_options.h"

#include "common/parse.h"
#include "common/program.h"
#include "help.h"

#include <candela/threads.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <limits>

namespace {

constexpr std::int64_t maxTurntable = 1'000'000;
constexpr std::int64_t maxShards = 1'000'000;

std::optional<PictureFormat> formatOfEnding(const std::filesystem::path& output) {
    std::string ending = output.extension().string();
    std::ranges::transform(ending, ending.begin(), [](char c) {
        return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    });
    if (ending == ".png") return PictureFormat::png;
    return ending == ".exr" ? std::optional(PictureFormat::exr) : std::nullopt;
}

const char* nameOf(PictureFormat format) {
    return format == PictureFormat::png ? "png" : format == PictureFormat::exr ? "exr" : "rgba8";
}

candela::ExrPixelType parsePixels(const std::string& text) {
    using enum candela::ExrPixelType;
    return parseWord("--exr", text, std::array{float32, half},
                     [](candela::ExrPixelType type) { return type == half ? "half" : "float"; });
}

candela::ExrCompression parseCompression(const std::string& text) {
    using enum candela::ExrCompression;
    return parseWord("--compression", text, std::array{zip, dwaa, piz, none},
                     [](candela::ExrCompression compression) { return candela::toString(compression); });
}

/// A number that Slurm has put into the environment of a task. Throws `UsageError` where it is not there.
std::int64_t slurmNumber(const char* variable, const char* otherwise = nullptr) {
    const char* text = std::getenv(variable);
    if (text == nullptr) text = otherwise;
    if (text == nullptr)
        throw UsageError("--shard slurm: " + std::string(variable) +
                         " is not set; it is in the tasks of a Slurm array (sbatch --array)");
    return parseInteger(variable, text, 0, std::numeric_limits<std::int32_t>::max());
}

/// Arrays need not begin with task 0, and may have steps.
Shard slurmShard() {
    const std::int64_t id = slurmNumber("SLURM_ARRAY_TASK_ID");
    const std::int64_t count = slurmNumber("SLURM_ARRAY_TASK_COUNT");
    const std::int64_t min = slurmNumber("SLURM_ARRAY_TASK_MIN", "0");
    const std::int64_t step = std::max<std::int64_t>(slurmNumber("SLURM_ARRAY_TASK_STEP", "1"), 1);
    const std::int64_t index = (id - min) / step;
    if (count < 1 || index < 0 || index >= count || (id - min) % step != 0)
        throw UsageError("--shard slurm: task " + std::to_string(id) + " is none of " +
                         std::to_string(count) + " from " + std::to_string(min) + " in steps of " +
                         std::to_string(step) + ": such an array needs --shard I/N");
    return {static_cast<std::uint64_t>(index), static_cast<std::uint64_t>(count)};
}

Shard parseShard(const std::string& text) {
    if (text == "slurm") return slurmShard();
    const std::size_t slash = text.find('/');
    if (slash == text.npos)
        throw UsageError("--shard \"" + text + "\": expected I/N, such as 1/8 to 8/8, or slurm");
    const std::int64_t count = parseInteger("--shard", text.substr(slash + 1), 1, maxShards);
    const std::int64_t number = parseInteger("--shard", text.substr(0, slash), 1, count);
    return {static_cast<std::uint64_t>(number - 1), static_cast<std::uint64_t>(count)};
}

void requireSingle(const Options& options) {
    if (options.format != PictureFormat::exr) return;
    if (options.isSequence())
        throw UsageError("-o - takes one .exr: readers can not tell where the next one begins");
}

void finishStandardOutput(const CLI::App& app, Options& options) {
    for (const char* option : {"--skip-existing", "--placeholders", "--mkdir"})
        if (app.count(option) > 0) throw UsageError(std::string(option) + " needs a file, and -o - is none");
    if (options.stats == "-") throw UsageError("--stats - and -o - exclude each other");
    requireSingle(options);
}

}  // namespace

void declareEncoding(CLI::App& app, Options& options) {
    const auto add = [&app](const char* name, auto read, const char* text, const char* type) {
        app.add_option_function<std::string>(name, read, text)->type_name(type)->group("Picture");
    };
    add(
        "--format",
        [&options](const std::string& text) {
            options.format =
                parseWord("--format", text, std::array{PictureFormat::png, PictureFormat::exr}, nameOf);
        },
        help::format, "png|exr");
    add(
        "--raw",
        [&options](const std::string& text) {
            options.format = parseWord("--raw", text, std::array{PictureFormat::rgba8}, nameOf);
        },
        help::raw, "rgba8");
    add(
        "--png-level",
        [&options](const std::string& text) {
            options.encoding.png.level = static_cast<int>(parseInteger("--png-level", text, 0, 9));
        },
        help::pngLevel, "N");
    add(
        "--exr", [&options](const std::string& text) { options.encoding.pixels = parsePixels(text); },
        help::exrPixels, "float|half");
    add(
        "--compression",
        [&options](const std::string& text) { options.encoding.exr.compression = parseCompression(text); },
        help::compression, "zip|piz|dwaa|none");
    app.add_option_function<std::string>(
           "--encode-threads",
           [&options](const std::string& text) {
               options.encoding.threads =
                   static_cast<unsigned>(parseInteger("--encode-threads", text, 0, candela::maxThreadCount));
           },
           help::encodeThreads)
        ->type_name("N")
        ->group("Running");
}

void declareSequence(CLI::App& app, Options& options) {
    const auto add = [&app](const char* name, auto read, const char* text, const char* type) {
        app.add_option_function<std::string>(name, read, text)->type_name(type)->group("Sequence");
    };
    add(
        "--frames", [&options](const std::string& text) { options.frames = FrameList::parse(text); },
        help::frames, "LIST");
    add(
        "--turntable",
        [&options](const std::string& text) {
            options.turntable = static_cast<int>(parseInteger("--turntable", text, 1, maxTurntable));
        },
        help::turntable, "N");
    add(
        "--shard", [&options](const std::string& text) { options.shard = parseShard(text); }, help::shard,
        "I/N|slurm");
    app.add_flag("--skip-existing", options.skipExisting, help::skipExisting)->group("Sequence");
    app.add_flag("--placeholders", options.placeholders, help::placeholders)->group("Sequence");
    app.add_flag("--keep-going", options.keepGoing, help::keepGoing)->group("Sequence");
    app.add_flag("--mkdir", options.mkdir, help::mkdir)->group("Sequence");
}

void finishOutput(const CLI::App& app, Options& options) {
    if (app.count("--format") > 0 && app.count("--raw") > 0)
        throw UsageError("--format and --raw exclude each other");
    const bool toStandardOutput = options.output == "-";
    if (app.count("--format") > 0 && !toStandardOutput)
        throw UsageError("--format needs -o -: the ending of a file chooses its format");
    if (!toStandardOutput && options.format != PictureFormat::rgba8) {
        const auto format = formatOfEnding(options.output);
        if (!format)
            throw UsageError("-o \"" + options.output.string() +
                             "\": expected a file name that ends in .png or .exr");
        options.format = *format;
    }
    if (toStandardOutput) finishStandardOutput(app, options);
    for (const char* option : {"--exr", "--compression"})
        if (app.count(option) > 0 && options.format != PictureFormat::exr)
            throw UsageError(std::string(option) + " needs an .exr picture");
    if (app.count("--png-level") > 0 && options.format != PictureFormat::png)
        throw UsageError("--png-level needs a .png picture");
    if (options.turntable && options.frames && options.frames->max() >= *options.turntable)
        throw UsageError("--frames: a turntable of " + std::to_string(*options.turntable) +
                         " frames has none of number " + std::to_string(options.frames->max()));
    if (options.placeholders) options.skipExisting = true;
}

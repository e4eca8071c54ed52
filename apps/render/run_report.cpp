#include "run_report.h"

#include "interruption.h"

#include <sys/resource.h>

#include <algorithm>
#include <iostream>
#include <utility>

namespace {

using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

/// JSON events of samples are so far apart.
constexpr std::chrono::seconds sampleInterval{1};

/// The most memory that the process has had.
std::uint64_t peakMemoryBytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

Json pictureJson(const char* event, const PlannedPicture& picture) {
    return {{"event", event}, {"picture", picture.name()}, {"frame", picture.frame}};
}

}  // namespace

RunReport::RunReport(const Options& options)
    : options_(options),
      progress_(options.quiet || options.jsonProgress ? Verbosity::quiet : Verbosity::normal) {}

/// Adds what every event has.
void RunReport::print(Json json) {
    if (!options_.jsonProgress) return;
    const std::uint64_t done = results_.size() + skipped_;
    json["done"] = done;
    json["of"] = count_;
    if (!json.contains("share"))
        json["share"] = count_ == 0 ? 1.0 : static_cast<double>(done) / static_cast<double>(count_);
    json["seconds"] = seconds();
    json["memory_bytes"] = peakMemoryBytes();
    std::cerr << json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n" << std::flush;
}

void RunReport::say(const std::string& line) {
    progress_.clear();
    std::cerr << line + "\n" << std::flush;
}

void RunReport::note(const std::string& text) {
    if (options_.quiet) return;
    const std::scoped_lock lock(mutex_);
    if (options_.jsonProgress) return print({{"event", "note"}, {"text", text}});
    say("note: " + text);
}

void RunReport::work(const std::string& text) {
    const std::scoped_lock lock(mutex_);
    progress_.show(text);
}

void RunReport::clear() {
    const std::scoped_lock lock(mutex_);
    progress_.clear();
}

void RunReport::begin(std::uint64_t count) {
    const std::scoped_lock lock(mutex_);
    count_ = count;
    print({{"event", "begin"}});
}

void RunReport::drawing(const PlannedPicture& picture, std::uint32_t sample, std::uint32_t samples) {
    const std::scoped_lock lock(mutex_);
    const std::string ofSamples =
        samples == 1 ? "" : ", sample " + std::to_string(sample + 1) + " of " + std::to_string(samples);
    progress_.show("drawing " + picture.name() + " (" + std::to_string(picture.index + 1) + " of " +
                   std::to_string(count_) + ")" + ofSamples);
    const bool isTime = Clock::now() - lastSample_ >= sampleInterval;
    if (!options_.jsonProgress || samples == 1 || !isTime) return;
    lastSample_ = Clock::now();
    Json json = pictureJson("drawing", picture);
    json["sample"] = sample;
    json["samples"] = samples;
    const double pictures =
        static_cast<double>(results_.size() + skipped_) + static_cast<double>(sample) / samples;
    json["share"] = pictures / static_cast<double>(count_);
    print(std::move(json));
}

void RunReport::written(const PictureResult& result) {
    const std::scoped_lock lock(mutex_);
    results_.push_back(result);
    Json json = pictureJson("written", result.picture);
    json["camera"] = result.camera;
    json["draw_ms"] = result.drawMilliseconds;
    json["encode_ms"] = result.encodeMilliseconds;
    json["bytes"] = result.bytes;
    print(std::move(json));
}

void RunReport::skipped(const PlannedPicture& picture, const std::string& reason) {
    const std::scoped_lock lock(mutex_);
    ++skipped_;
    Json json = pictureJson("skipped", picture);
    json["reason"] = reason;
    print(std::move(json));
}

void RunReport::failed(const PlannedPicture& picture, const std::string& error) {
    const std::scoped_lock lock(mutex_);
    failures_.push_back(picture.name());
    Json json = pictureJson("failed", picture);
    json["error"] = error;
    print(std::move(json));
    if (!options_.jsonProgress) say("candela-render: " + error);
}

void RunReport::interrupted(int signal) {
    const std::scoped_lock lock(mutex_);
    if (options_.jsonProgress) return print({{"event", "interrupted"}, {"signal", signalName(signal)}});
    std::string skips;
    if (skipped_ > 0) skips = " and " + std::to_string(skipped_) + " left out";
    say("candela-render: interrupted by " + std::string(signalName(signal)) + ": of " +
        std::to_string(count_) + (count_ == 1 ? " picture " : " pictures ") +
        std::to_string(results_.size()) + (results_.size() == 1 ? " is written" : " are written") + skips);
}

void RunReport::end() {
    const std::scoped_lock lock(mutex_);
    print({{"event", "end"}, {"failed", failures_.size()}});
}

std::vector<PictureResult> RunReport::results() const {
    const std::scoped_lock lock(mutex_);
    std::vector<PictureResult> sorted = results_;
    std::ranges::sort(sorted, {}, [](const PictureResult& result) { return result.picture.index; });
    return sorted;
}

std::uint64_t RunReport::skippedCount() const {
    const std::scoped_lock lock(mutex_);
    return skipped_;
}

std::vector<std::string> RunReport::failures() const {
    const std::scoped_lock lock(mutex_);
    return failures_;
}

double RunReport::seconds() const {
    return std::chrono::duration<double>(Clock::now() - start_).count();
}

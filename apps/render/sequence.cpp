#include "sequence.h"

#include "band_writer.h"
#include "common/output_file.h"
#include "common/timing.h"
#include "encoder_pool.h"
#include "exr_metadata.h"
#include "interruption.h"
#include "picture_file.h"
#include "placeholder.h"
#include "whole_picture.h"

#include <candela/error.h>
#include <candela/threads.h>
#include <candela/whole_file.h>

#include <exception>
#include <memory>
#include <mutex>
#include <system_error>

namespace {

namespace fs = std::filesystem;

/// How often --stats draws and times a single frame.
constexpr int statsDrawings = 5;

/// The most memory that pictures take which wait to be encoded or are being.
constexpr std::size_t maxWaitingBytes = std::size_t{1} << 30;

void makeFolder(const PlannedPicture& picture) {
    if (!picture.path.has_parent_path()) return;
    std::error_code error;
    fs::create_directories(picture.path.parent_path(), error);
    if (error)
        throw candela::Error(
            candela::ErrorKind::environment, picture.path.string(),
            "can not create the folder " + picture.path.parent_path().string() + ": " + error.message());
}

/// Draws, and hands each picture to the encoders.
class Sequence {
  public:
    explicit Sequence(const SequenceSource& source)
        : source_(source),
          options_(source.options),
          report_(source.report),
          encoding_(source.options.encoding),
          pool_(encoderThreads(), maxWaitingBytes) {}

    SequenceResult run();

  private:
    /// A picture on its way to its file.
    struct Work {
        PlannedPicture picture;
        std::uint64_t turn = 0;  ///< On standard output.
        double drawMilliseconds = 0.0;
        DrawnPicture drawn;
        std::unique_ptr<BandWriter> bands = {};  ///< Of a picture that is drawn in parts.
        std::optional<Placeholder> placeholder;
    };

    unsigned encoderThreads() const {
        return options_.encoding.threads > 0 ? options_.encoding.threads : candela::threadCount();
    }
    void drawPicture(const PlannedPicture& picture);
    void draw(Work& work);
    void drawWhole(Work& work, const SampleSource& source);
    void drawBands(Work& work, const SampleSource& source);
    void encode(Work& work);
    /// Returns the bytes of the file. `hasTurn` becomes false once standard output has been waited for.
    std::uint64_t write(Work& work, bool& hasTurn);
    void addMetadata(const Work& work, DrawnPicture& picture) const;
    /// Of the exception that is being handled.
    void fail(const PlannedPicture& picture);
    bool isStopped();
    void finish();
    [[noreturn]] void throwMissing() const;

    SequenceSource source_;
    const Options& options_;
    RunReport& report_;
    EncodingOptions encoding_;
    SequenceResult result_;
    PictureNotes pictureNotes_;
    LayerNotes layerNotes_;
    std::mutex failureMutex_;
    std::exception_ptr failure_;
    OrderedOutput standardOutput_;
    std::uint64_t turns_ = 0;
    EncoderPool pool_;  ///< Destroyed first: its jobs use all of the above.
};

SequenceResult Sequence::run() {
    const Interruption interruption;
    const std::uint64_t count = source_.plan.count();
    report_.begin(count);
    // One picture is encoded by all threads, of several each by one. Bands follow each other.
    if (count == 1 || source_.writer.isParted()) encoding_.exr.threads = encoderThreads();
    for (std::uint64_t i = 0; i < count && !isStopped(); ++i) {
        const PlannedPicture picture = source_.plan[i];
        try {
            drawPicture(picture);
        } catch (const Interrupted&) {
            break;
        } catch (const std::exception&) {
            fail(picture);
        }
    }
    finish();
    return std::move(result_);
}

bool Sequence::isStopped() {
    if (Interruption::signal() != 0) return true;
    const std::scoped_lock lock(failureMutex_);
    return failure_ != nullptr && !options_.keepGoing;
}

void Sequence::drawPicture(const PlannedPicture& picture) {
    const auto work = std::make_shared<Work>();
    work->picture = picture;
    if (!picture.path.empty()) {
        if (isSkipped(options_, picture)) return report_.skipped(picture, "it is there");
        if (options_.mkdir) makeFolder(picture);
        checkWritable(picture.path);
        if (options_.placeholders) {
            std::optional<Placeholder> taken = Placeholder::take(picture.path);
            if (!taken) return report_.skipped(picture, "another process draws it");
            work->placeholder.emplace(std::move(*taken));
            // Whoever had it may have finished it meanwhile.
            if (isSkipped(options_, picture)) return report_.skipped(picture, "it is there");
        }
    }
    draw(*work);
    work->turn = turns_++;
    const std::size_t bytes = work->drawn.bytes();
    pool_.add(bytes, [this, work] { encode(*work); });
}

void Sequence::draw(Work& work) {
    Samples samples(options_, source_.scene, source_.lighting, source_.plan, work.picture);
    const std::optional<candela::CameraView> previousView = samples.keepFrameBefore();
    const SampleSource source{[&](std::uint32_t sample) {
                                  if (Interruption::signal() != 0) throw Interrupted{};
                                  report_.drawing(work.picture, sample, samples.count());
                                  return samples.view(sample);
                              },
                              samples.moves(), previousView};
    if (source_.writer.isParted()) {
        drawBands(work, source);
    } else {
        drawWhole(work, source);
    }
    work.drawMilliseconds = result_.timings.back().milliseconds;
    layerNotes_.add(source_.writer.layerCounts());
    if (!options_.quiet && options_.debug.view == candela::DebugView::none)
        pictureNotes_.add(source_.writer.exposureCounts(work.drawn));
}

void Sequence::drawWhole(Work& work, const SampleSource& source) {
    // Compiles and allocates.
    if (options_.stats && result_.timings.empty()) source_.writer.draw(source);
    const int drawings = options_.stats && !options_.isSequence() ? statsDrawings : 1;
    for (int drawing = 0; drawing < drawings; ++drawing)
        result_.timings.push_back(source_.writer.draw(source));
    work.drawn = source_.writer.take();
    if (options_.format == PictureFormat::exr) addMetadata(work, work.drawn);
}

/// Once, with --stats too: such pictures take long.
void Sequence::drawBands(Work& work, const SampleSource& source) {
    work.bands = std::make_unique<BandWriter>(work.picture.path, options_.height, options_.format, encoding_);
    result_.timings.push_back(source_.writer.drawBands(source, [&](DrawnPicture band) {
        if (options_.format == PictureFormat::exr) addMetadata(work, band);
        work.bands->add(std::move(band));
    }));
}

void Sequence::addMetadata(const Work& work, DrawnPicture& picture) const {
    ExrMetadata metadata;
    metadata.view = source_.writer.view();
    metadata.origin = source_.scene.origin;
    metadata.aspect = static_cast<float>(options_.width) / static_cast<float>(options_.height);
    if (options_.panorama) metadata.aspect.reset();
    metadata.frame = work.picture.frame;
    metadata.framesPerSecond = options_.sampling.framesPerSecond;
    metadata.camera = source_.plan.cameras()[work.picture.camera].name;
    metadata.workingSpace = source_.color.workingSpace();
    metadata.chromaticities = picture.chromaticities;
    for (candela::ExrAttribute& attribute : exrMetadata(metadata))
        picture.attributes.push_back(std::move(attribute));
}

/// On an encoder's thread.
void Sequence::encode(Work& work) {
    bool hasTurn = work.picture.path.empty();
    try {
        PictureResult result{work.picture, source_.plan.cameras()[work.picture.camera].name,
                             work.drawMilliseconds, 0.0, 0};
        result.encodeMilliseconds = measureMilliseconds([&] { result.bytes = write(work, hasTurn); });
        if (work.bands) result.encodeMilliseconds += work.bands->milliseconds();
        work.placeholder.reset();
        report_.written(result);
    } catch (const std::exception&) {
        fail(work.picture);
        if (hasTurn) standardOutput_.leaveOut(work.turn);
    }
}

std::uint64_t Sequence::write(Work& work, bool& hasTurn) {
    const bool hasPath = !work.picture.path.empty();
    if (work.bands) {
        const std::uint64_t bytes = work.bands->end();
        hasTurn = false;
        if (hasPath)
            work.bands->finish();
        else
            standardOutput_.write(work.turn, [&] { work.bands->finish(); });
        return bytes;
    }
    const std::vector<std::byte> bytes =
        encodePicture(work.picture.name(), std::move(work.drawn), options_.format, encoding_);
    hasTurn = false;
    if (hasPath)
        candela::writeWholeFile(work.picture.path, bytes);
    else
        standardOutput_.write(work.turn, bytes);
    return bytes.size();
}

void Sequence::fail(const PlannedPicture& picture) {
    const std::scoped_lock lock(failureMutex_);
    if (!failure_) failure_ = std::current_exception();
    if (!options_.keepGoing) return;
    try {
        throw;
    } catch (const std::bad_alloc&) {
        report_.failed(picture, picture.name() + ": there is not enough memory");
    } catch (const std::exception& error) {
        report_.failed(picture, error.what());
    }
}

/// Waits for the encoders and says what came of it all.
void Sequence::finish() {
    pool_.finish();
    result_.signal = Interruption::signal();
    if (result_.signal != 0) return report_.interrupted(result_.signal);
    report_.end();
    if (failure_ && !options_.keepGoing) std::rethrow_exception(failure_);
    pictureNotes_.tell(report_);
    layerNotes_.tell(report_, options_.layers);
    if (failure_) throwMissing();
}

void Sequence::throwMissing() const {
    const std::vector<std::string> failures = report_.failures();
    const std::uint64_t count = source_.plan.count();
    std::string names;
    for (const std::string& name : failures) names += (names.empty() ? "" : ", ") + name;
    throw candela::Error(candela::ErrorKind::environment, "",
                         std::to_string(failures.size()) + " of " + std::to_string(count) +
                             (count == 1 ? " picture is" : " pictures are") + " missing: " + names);
}

}  // namespace

bool isSkipped(const Options& options, const PlannedPicture& picture) {
    return options.skipExisting && !picture.path.empty() && isWholePicture(picture.path);
}

SequenceResult drawSequence(const SequenceSource& source) {
    return Sequence(source).run();
}

#include "band_writer.h"

#include "common/output_file.h"
#include "common/timing.h"

#include <unistd.h>

#include <span>
#include <utility>

namespace {

candela::WholeFile fileAt(const std::filesystem::path& path) {
    return path.empty() ? candela::WholeFile(STDOUT_FILENO, "standard output") : candela::WholeFile(path);
}

}  // namespace

BandWriter::BandWriter(const std::filesystem::path& path, int height, PictureFormat format,
                       const EncodingOptions& options)
    : file_(fileAt(path)),
      height_(static_cast<std::uint32_t>(height)),
      format_(format),
      options_(options),
      pool_(1, 0) {}

void BandWriter::add(DrawnPicture band) {
    const auto shared = std::make_shared<DrawnPicture>(std::move(band));
    pool_.add(1, [this, shared] {
        try {
            requireNoFailure();
            milliseconds_ += measureMilliseconds([&] { encode(*shared); });
        } catch (...) {
            const std::scoped_lock lock(failureMutex_);
            failure_ = std::current_exception();
        }
    });
    requireNoFailure();
}

void BandWriter::requireNoFailure() {
    const std::scoped_lock lock(failureMutex_);
    if (failure_) std::rethrow_exception(failure_);
}

void BandWriter::encode(DrawnPicture& band) {
    if (format_ == PictureFormat::exr) return encodeRadiance(band);
    if (format_ == PictureFormat::rgba8) {
        makeOpaque(band.rgba);
        return file_.write(std::as_bytes(std::span(band.rgba)));
    }
    if (!png_)
        png_.emplace(file_, static_cast<std::uint32_t>(band.width), height_, band.encoding,
                     candela::PngAlpha::none, options_.png);
    png_->write(band.rgba);
}

void BandWriter::encodeRadiance(const DrawnPicture& band) {
    if (!exr_)
        exr_.emplace(file_, static_cast<std::uint32_t>(band.width), height_,
                     radianceChannels(band.aovs, options_.pixels), band.chromaticities, band.attributes,
                     options_.exr);
    const RadiancePlanes planes(band.radiance, band.aovs);
    exr_->write(planes.values());
}

std::uint64_t BandWriter::end() {
    pool_.finish();
    requireNoFailure();
    if (png_) png_->finish();
    if (exr_) exr_->finish();
    return file_.size();
}

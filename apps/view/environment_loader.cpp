#include "environment_loader.h"

#include <candela/scene.h>

#include <chrono>
#include <exception>
#include <utility>

namespace {

EnvironmentLoader::Result readFile(const std::string& file, candela::Strictness strictness) {
    EnvironmentLoader::Result result{file, {}, ""};
    SceneOptions options;
    options.strictness = strictness;
    options.environment.source = EnvironmentOption::Source::file;
    options.environment.file = file;
    try {
        result.light = loadEnvironment(candela::Scene{}, options);
    } catch (const std::exception& error) {
        result.error = error.what();
    }
    return result;
}

}  // namespace

EnvironmentLoader::~EnvironmentLoader() {
    if (thread_.joinable()) thread_.join();
}

void EnvironmentLoader::start(const std::string& file, candela::Strictness strictness, void (*wake)()) {
    wanted_ = {file, strictness, wake};
    if (!result_.valid()) read();
}

void EnvironmentLoader::read() {
    std::promise<Result> promise;
    result_ = promise.get_future();
    thread_ = std::thread([request = wanted_, promise = std::move(promise)]() mutable {
        promise.set_value(readFile(request.file, request.strictness));
        request.wake();
    });
}

std::optional<EnvironmentLoader::Result> EnvironmentLoader::take() {
    if (!result_.valid() || result_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
        return std::nullopt;
    thread_.join();
    Result result = result_.get();
    if (result.file != wanted_.file) {
        read();
        return std::nullopt;
    }
    wanted_ = {};
    return result;
}

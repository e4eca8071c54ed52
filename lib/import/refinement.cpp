#include "import/refinement.h"

#include "import/abi_reader.h"
#include "import/import_refined_cage.h"

#include <candela/error.h>

#include <new>
#include <stdexcept>
#include <utility>

namespace candela {

// The C functions of the table. Each turns `self` back into the object.
struct Refinement::Functions {
    static Refinement& from(void* self) { return *static_cast<Refinement*>(self); }

    static void fail(void* self, const char* element, const char* reason) {
        from(self).guarded([&] {
            const std::string at = element && *element ? oneLine(element) + ": " : std::string();
            if (!reason || !*reason)
                from(self).refuse(
                    joined(at, "the plugin '", from(self).plugin_.plugin.name, "' gives no reason"));
            from(self).refuse(at + oneLine(reason));
        });
    }
    static candela_status deliver(void* self, const candela_refined_cage* delivered) {
        return from(self).guarded([&] { from(self).take(delivered); }) ? CANDELA_OK : CANDELA_FAILED;
    }
};

Refinement::Refinement(const LoadedPlugin& plugin, const Cage& cage, const candela_cage& cageStruct)
    : plugin_(plugin), cage_(cage), cageStruct_(cageStruct) {}

void Refinement::refuse(const std::string& text) const {
    AbiReader("cage", std::nullopt, cage_.name.c_str()).refuse(text);
}

void Refinement::blamePlugin(const char* how) const {
    refuse(joined("the plugin '", plugin_.plugin.name, "' ", how));
}

// Runs an action on behalf of the plugin. After the first failure nothing runs any more.
template <class Action>
bool Refinement::guarded(Action action) noexcept {
    if (failure_) return false;
    try {
        action();
        return true;
    } catch (...) {
        failure_ = std::current_exception();
        return false;
    }
}

void Refinement::take(const candela_refined_cage* delivered) {
    if (refined_) blamePlugin("delivers more than once");
    const std::string kind = joined("the table of the plugin '", plugin_.plugin.name, "' for cage");
    const AbiReader element(kind.c_str(), std::nullopt, cage_.name.c_str());
    if (!delivered) element.refuse("it is NULL");
    const auto copy = copyOf(delivered);
    if (!copy) element.refuse("struct_size " + sizeFault(delivered));
    refined_ = refinedCageFrom(*copy, element, cage_);
}

// A plugin must not throw. Where it does all the same and the exception can be caught, it is an error like
// others.
void Refinement::call(std::uint32_t level) {
    candela_refinement interface {};
    interface.struct_size = sizeof interface;
    interface.self = this;
    interface.fail = Functions::fail;
    interface.deliver = Functions::deliver;
    candela_status status = CANDELA_FAILED;
    try {
        status = plugin_.subdivider.refine(&interface, &cageStruct_, level);
    } catch (const std::bad_alloc&) {
        if (!failure_) throw;
    } catch (const std::length_error&) {
        if (!failure_) throw;
    } catch (...) {
        if (!failure_) blamePlugin("threw an exception, which the plugin interface forbids");
    }
    if (failure_) std::rethrow_exception(failure_);
    if (status != CANDELA_OK) blamePlugin("failed and gave no reason");
    if (!refined_) blamePlugin("has delivered nothing");
}

RefinedCage Refinement::run(std::uint32_t level) {
    const auto notEnough = [&] {
        const AbiReader element("cage", std::nullopt, cage_.name.c_str());
        return Error(ErrorKind::limit, "",
                     joined(element.label(), ": there is not enough memory to refine it to level ", level));
    };
    try {
        call(level);
    } catch (const std::bad_alloc&) {
        throw notEnough();
    } catch (const std::length_error&) {
        throw notEnough();
    }
    refined_->level = level;
    return std::move(*refined_);
}

}  // namespace candela

#include "module.h"

#include <candela/error.h>

#include <exception>

namespace candela::python {

namespace nb = nanobind;

namespace {

const char* classOf(ErrorKind kind) {
    switch (kind) {
        case ErrorKind::badInput:
            return "InputError";
        case ErrorKind::unsupported:
            return "UnsupportedError";
        case ErrorKind::environment:
            return "MachineError";
        case ErrorKind::limit:
            return "LimitError";
        case ErrorKind::cancelled:
            return "CancelledError";
    }
    return "Error";
}

}  // namespace

/// The classes are those of candela/errors.py.
void bindErrors(nb::module_&) {
    nb::register_exception_translator([](const std::exception_ptr& exception, void*) {
        try {
            std::rethrow_exception(exception);
        } catch (const Error& error) {
            const nb::object cls = nb::module_::import_("candela.errors").attr(classOf(error.kind()));
            const nb::object raised = cls(nb::str(error.what()), nb::str(error.path().c_str()));
            PyErr_SetObject(cls.ptr(), raised.ptr());
        }
    });
}

}  // namespace candela::python

// Translates Lacuna's errors into the exceptions of python/lacuna/_errors.py.
#include <lacuna/files.h>
#include <lacuna/lacuna.h>
#include <nanobind/nanobind.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

#include "options.h"
#include "parts.h"

namespace nb = nanobind;

namespace lacuna::python {
namespace {

// Drivers' texts and file names in messages need not be UTF-8. Other bytes become \xNN.
nb::object text_of(const char* message) {
    PyObject* const text = PyUnicode_DecodeUTF8(
        message, static_cast<Py_ssize_t>(std::char_traits<char>::length(message)),
        "backslashreplace");
    if (text == nullptr) throw nb::python_error();
    return nb::steal(text);
}

// Options in messages are Python's arguments: --inside-by-radius becomes inside_by_radius.
std::string worded(std::string_view message) {
    std::string text;
    while (!message.empty()) {
        const bool begins_word = text.empty() || text.back() == ' ' || text.back() == '(';
        const std::size_t end = message.find_first_not_of("abcdefghijklmnopqrstuvwxyz-");
        const std::string_view word = message.substr(0, std::max<std::size_t>(1, end));
        const std::string argument =
            begins_word && word.starts_with("--") ? argument_called(word.substr(2)) : "";
        text += argument == "invert" ? "invert=True" : argument.empty() ? word : argument;
        message.remove_prefix(word.size());
    }
    return text;
}

template <class... Parts>
void raise(const char* type, const Parts&... parts) {
    const nb::object errors = nb::module_::import_("lacuna._errors");
    const nb::object error = errors.attr(type)(text_of(worded(parts).c_str())...);
    PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(error.ptr())), error.ptr());
}

void refuse(const char* type, const BadRequest& error) {
    raise(type, argument_called(error.option()), error.value(), error.reason());
}

// Translates what is thrown if, during the work, the system refuses memory or a thread of oneTBB or
// std::async.
void translate_refusal(const std::exception_ptr& thrown) {
    try {
        std::rethrow_exception(thrown);
    } catch (const std::bad_alloc&) {
        raise("MemoryRefused", "", "", "the system gives no more memory");
    } catch (const std::system_error& error) {
        raise("Unavailable", error.what());
    } catch (const std::runtime_error& error) {
        if (!std::string_view(error.what()).starts_with("pthread_create")) throw;
        raise("Unavailable", error.what());
    }
}

void translate(const std::exception_ptr& thrown, void*) {
    try {
        std::rethrow_exception(thrown);
    } catch (const MemoryRefused& error) {
        refuse("MemoryRefused", error);
    } catch (const BadRequest& error) {
        refuse("BadRequest", error);
    } catch (const Unavailable& error) {
        raise("Unavailable", error.what());
    } catch (const DeviceError& error) {
        raise("DeviceError", error.what());
    } catch (const FileError& error) {
        raise("FileError", error.what());
    } catch (...) {
        translate_refusal(thrown);
    }
}

}  // namespace

void add_errors(nb::module_&) {
    nb::register_exception_translator(translate);
}

}  // namespace lacuna::python

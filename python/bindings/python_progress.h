// A Python callback as burnish's Progress: runs with the lock, and ends the work when it returns False or raises.
#pragma once

#include <burnish/base/progress.h>

#include <pybind11/pybind11.h>

#include <optional>
#include <utility>

namespace burnish::python {

class PythonProgress {
public:
    /// `callback(stage, done)`; None reports nothing, but still lets Ctrl-C through.
    explicit PythonProgress(pybind11::object callback) : m_callback(std::move(callback)) {}

    /// Runs `work(Progress)` without the interpreter's lock. Raises what the callback raised.
    template <class Work>
    auto run(Work&& work) {
        try {
            const pybind11::gil_scoped_release unlocked;
            return work(Progress([this](const std::string& stage, float done) { return call(stage, done); }));
        } catch (const Error&) {
            if (m_raised) throw std::exchange(m_raised, std::nullopt).value();
            throw;
        }
    }

private:
    bool call(const std::string& stage, float done) {
        const pybind11::gil_scoped_acquire locked;
        try {
            if (PyErr_CheckSignals() != 0) throw pybind11::error_already_set();
            return m_callback.is_none() || !m_callback(stage, done).is(pybind11::bool_(false));
        } catch (pybind11::error_already_set& error) {
            m_raised.emplace(std::move(error));
            return false;
        }
    }

    pybind11::object m_callback;
    std::optional<pybind11::error_already_set> m_raised;
};

}  // namespace burnish::python

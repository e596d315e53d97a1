#pragma once

#include <stdexcept>
#include <string>

namespace voroprobe
{

//! What the program tells its caller. Documented in README.md, "Exit status".
enum class ExitStatus : int
{
    kDone = 0,
    kInternal = 1,     //!< a defect of ours, or an output that could not be written
    kUsage = 2,        //!< a wrong option or combination of options
    kInput = 3,        //!< an input that cannot be read or is not what was asked for
    kEmptySurface = 4, //!< the isovalue is outside the range of the samples
    kIncomplete = 5,   //!< a promise about the mesh does not hold
    kBudget = 6,       //!< out of memory, or a budget given by the user is spent
    kInterrupted = 130 //!< SIGINT or SIGTERM
};

//! Base of everything this project throws on purpose. The message is one line that names what is wrong,
//! where, the value found and the values allowed. Only `main` catches.
class Error : public std::runtime_error
{
public:
    Error(ExitStatus status, const std::string& message) : std::runtime_error(message), status_(status) {}

    [[nodiscard]] ExitStatus status() const { return status_; }

private:
    ExitStatus status_;
};

//! A wrong option, or a function called with a value outside its documented range.
class UsageError : public Error
{
public:
    explicit UsageError(const std::string& message) : Error(ExitStatus::kUsage, message) {}
};

//! An input file or volume that cannot be used.
class InputError : public Error
{
public:
    explicit InputError(const std::string& message) : Error(ExitStatus::kInput, message) {}
};

//! An output that cannot be written.
class OutputError : public Error
{
public:
    explicit OutputError(const std::string& message) : Error(ExitStatus::kInternal, message) {}
};

//! The surface has no point in the domain.
class EmptySurfaceError : public Error
{
public:
    explicit EmptySurfaceError(const std::string& message) : Error(ExitStatus::kEmptySurface, message) {}
};

} // namespace voroprobe

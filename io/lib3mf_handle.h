#pragma once

#include <string>
#include <utility>

#include <Model/COM/NMR_DLLInterfaces.h>

//! lib3mf's C interface with owners and exceptions.
namespace voroprobe
{

//! Owns one of lib3mf's objects.
class Lib3mfHandle
{
public:
    Lib3mfHandle() = default;
    Lib3mfHandle(Lib3mfHandle&& other) noexcept : object_(std::exchange(other.object_, nullptr)) {}
    Lib3mfHandle& operator=(Lib3mfHandle&& other) noexcept
    {
        std::swap(object_, other.object_);
        return *this;
    }
    ~Lib3mfHandle()
    {
        if (object_ != nullptr)
            NMR::lib3mf_release(object_);
    }

    [[nodiscard]] NMR::PLib3MFBase* get() const { return object_; }

    //! Where a function of lib3mf puts what it makes. \pre empty
    NMR::PLib3MFBase** receive() { return &object_; }

private:
    NMR::PLib3MFBase* object_ = nullptr;
};

//! What lib3mf says went wrong on an object.
inline std::string lib3mf_reason(const Lib3mfHandle& object)
{
    DWORD code = 0;
    LPCSTR text = nullptr;
    NMR::lib3mf_getlasterror(object.get(), &code, &text);
    return text != nullptr && *text != '\0' ? std::string("lib3mf: ") + text
                                            : "lib3mf: error " + std::to_string(code);
}

//! The text that one of lib3mf's functions copies into a buffer once it was asked for the length.
template <typename Getter>
std::string lib3mf_text(Getter getter)
{
    ULONG length = 0;
    if (getter(nullptr, 0, &length) != 0)
        return {};
    std::string text(length + 1, '\0');
    if (getter(text.data(), length + 1, &length) != 0)
        return {};
    text.resize(text.find('\0') == std::string::npos ? text.size() : text.find('\0'));
    return text;
}

} // namespace voroprobe

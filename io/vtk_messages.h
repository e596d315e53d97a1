#pragma once

#include <memory>
#include <string>

namespace voroprobe
{

//! Catches what VTK would print while an object of this kind lives: the library prints nothing, and the first
//! error is the reason we give. Process-wide, since VTK's message window is: not to be used from several
//! threads at once.
class VtkMessages
{
public:
    VtkMessages();
    VtkMessages(const VtkMessages&) = delete;
    VtkMessages& operator=(const VtkMessages&) = delete;
    ~VtkMessages();

    //! The first error, as one line without VTK's source lines and addresses; empty when there was none.
    [[nodiscard]] std::string first_error() const;

    //! The same for warnings: VTK's legacy reader only warns where a file is too short.
    [[nodiscard]] std::string first_warning() const;

private:
    class Window;
    std::unique_ptr<Window> window_;
};

} // namespace voroprobe

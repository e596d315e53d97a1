#include "io/vtk_messages.h"

#include <vtkLogger.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

namespace voroprobe
{

namespace
{

//! Keeps the first error instead of showing it.
class KeepingWindow final : public vtkOutputWindow
{
public:
    static KeepingWindow* New();
    vtkTypeMacro(KeepingWindow, vtkOutputWindow)

        void DisplayText(const char*) override
    {
    }
    void DisplayWarningText(const char* text) override { keep_warning(text); }
    void DisplayGenericWarningText(const char* text) override { keep_warning(text); }
    void DisplayDebugText(const char*) override {}
    void DisplayErrorText(const char* text) override
    {
        if (first_error.empty())
            first_error = text;
    }

    std::string first_error;
    std::string first_warning;

private:
    void keep_warning(const char* text)
    {
        if (first_warning.empty())
            first_warning = text;
    }
};
vtkStandardNewMacro(KeepingWindow);

//! "ERROR: In file.cxx, line 7\nvtkSTLReader (0x55d0): what happened\n\n" becomes "what happened".
std::string reason_of(const std::string& message)
{
    const auto object_end = message.find("): ");
    std::string reason = object_end == std::string::npos ? message : message.substr(object_end + 3);
    reason.erase(reason.find_last_not_of(" \r\n") + 1);
    for (char& c : reason)
        c = c == '\n' || c == '\r' ? ' ' : c;
    return reason;
}

} // namespace

class VtkMessages::Window
{
public:
    Window()
    {
        previous_ = vtkOutputWindow::GetInstance();
        vtkOutputWindow::SetInstance(keeping_);
        vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
    }
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;
    ~Window()
    {
        vtkLogger::SetStderrVerbosity(previous_verbosity_);
        vtkOutputWindow::SetInstance(previous_);
    }

    [[nodiscard]] const std::string& first_error() const { return keeping_->first_error; }
    [[nodiscard]] const std::string& first_warning() const { return keeping_->first_warning; }

private:
    vtkLogger::Verbosity previous_verbosity_ = vtkLogger::GetCurrentVerbosityCutoff();
    vtkSmartPointer<vtkOutputWindow> previous_;
    vtkSmartPointer<KeepingWindow> keeping_ = vtkSmartPointer<KeepingWindow>::New();
};

VtkMessages::VtkMessages() : window_(std::make_unique<Window>()) {}

VtkMessages::~VtkMessages() = default;

std::string VtkMessages::first_error() const
{
    return reason_of(window_->first_error());
}

std::string VtkMessages::first_warning() const
{
    return reason_of(window_->first_warning());
}

} // namespace voroprobe

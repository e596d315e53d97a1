#include "cli/console_progress.h"

#include <algorithm>
#include <iostream>
#include <optional>
#include <set>
#include <string>

#include <nlohmann/json.hpp>
#include <sys/ioctl.h>
#include <unistd.h>

#include "cli/interrupt.h"
#include "cli/json_values.h"
#include "cli/number_text.h"
#include "support/stopwatch.h"

namespace voroprobe
{

namespace
{

constexpr double kSecondsBetweenLines = 0.1;

class SilentProgress : public ProgressSink
{
public:
    void report(const ProgressReport& /*report*/) override {}
    [[nodiscard]] bool stop_requested() const override { return interrupt_requested(); }
};

//! Lets through what is worth a line and keeps the rate.
class PacedProgress : public SilentProgress
{
public:
    void report(const ProgressReport& report) final
    {
        const bool new_phase = phases_seen_.emplace(report.phase).second;
        const double now = clock_.seconds();
        if (!new_phase && now - last_line_ < kSecondsBetweenLines)
            return;
        last_line_ = now;
        if (report.vertices > 0 && !first_vertices_at_)
            first_vertices_at_ = now;
        const double busy = now - first_vertices_at_.value_or(now);
        print(report, busy > 0.0 ? static_cast<double>(report.vertices) / busy : 0.0, now);
    }

protected:
    virtual void print(const ProgressReport& report, double vertices_per_second, double seconds) = 0;

private:
    Stopwatch clock_;
    std::set<std::string, std::less<>> phases_seen_;
    double last_line_ = 0.0;
    std::optional<double> first_vertices_at_;
};

class JsonProgress final : public PacedProgress
{
    void print(const ProgressReport& report, double vertices_per_second, double seconds) override
    {
        const nlohmann::ordered_json line{{"phase", report.phase},
                                          {"vertices", report.vertices},
                                          {"bad_facets_left", report.bad_facets_left},
                                          {"vertices_per_second", vertices_per_second},
                                          {"seconds", seconds}};
        std::cerr << json_text(line, kOneLine) + '\n' << std::flush;
    }
};

std::size_t terminal_width()
{
    constexpr std::size_t kUsualWidth = 80;
    winsize size{};
    return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : kUsualWidth;
}

//! Nobody knows how many vertices a mesh will have: a bad facet is taken for one vertex to come.
std::string bar_text(const ProgressReport& report)
{
    constexpr std::size_t kLength = 20;
    const std::size_t known_work = std::max<std::size_t>(1, report.vertices + report.bad_facets_left);
    const std::size_t filled = kLength * report.vertices / known_work;
    return '[' + std::string(filled, '#') + std::string(kLength - filled, '.') + ']';
}

class BarProgress final : public PacedProgress
{
public:
    BarProgress() { set_bar_shown(true); }
    BarProgress(const BarProgress&) = delete;
    BarProgress& operator=(const BarProgress&) = delete;
    ~BarProgress() override
    {
        std::cerr << kWipeLine << std::flush;
        set_bar_shown(false);
    }

private:
    void print(const ProgressReport& report, double vertices_per_second, double /*seconds*/) override
    {
        std::string line = bar_text(report) + ' ' + std::string(report.phase);
        if (report.vertices > 0)
            line += "  " + count_text(report.vertices) + " vertices, " + count_text(report.bad_facets_left) +
                    " bad facets left, " + count_text(static_cast<std::size_t>(vertices_per_second)) + "/s";
        line.resize(std::min(line.size(), terminal_width() - 1)); // a wrapped line could not be wiped
        std::cerr << kWipeLine << line << std::flush;
    }
};

} // namespace

std::unique_ptr<ProgressSink> make_progress(ProgressMode mode)
{
    const bool terminal = isatty(STDERR_FILENO) == 1;
    if (mode == ProgressMode::kJson)
        return std::make_unique<JsonProgress>();
    if (mode == ProgressMode::kBar || (mode == ProgressMode::kAuto && terminal))
        return std::make_unique<BarProgress>();
    return std::make_unique<SilentProgress>();
}

} // namespace voroprobe

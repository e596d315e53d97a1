#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "io/volume_reader.h"
#include "support/error.h"
#include "temporary_folder.h"

namespace voroprobe
{

//! 0, 1, 2, ... as many as a small volume of 6 x 5 x 4 has samples.
template <class Sample>
std::vector<Sample> ramp(std::size_t count = 6 * 5 * 4)
{
    std::vector<Sample> samples(count);
    for (std::size_t i = 0; i < count; ++i)
        samples[i] = static_cast<Sample>(i);
    return samples;
}

//! Samples in the order of the file, where the file's axes are the canonical ones.
inline std::vector<double> values_of(const Volume& volume)
{
    return std::visit([](const auto& samples) { return std::vector<double>(samples.begin(), samples.end()); },
                      volume.samples);
}

//! Reads `content` as a file of that name.
inline ReadVolume read_content(const std::string& name, const std::string& content,
                               const ReadOptions& options = {})
{
    const TemporaryFolder folder;
    return read_volume(folder.file(name, content), options);
}

//! The message of the InputError that reading throws: one line with the path in front; empty where it throws
//! none.
inline std::string refusal_of_path(const std::filesystem::path& path, const ReadOptions& options = {})
{
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    std::string message;
    try
    {
        read_volume(path, options);
    }
    catch (const InputError& error)
    {
        message = error.what();
    }
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    EXPECT_TRUE(message.starts_with(path.string())) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    return message;
}

inline std::string refusal(const std::string& name, const std::string& content,
                           const ReadOptions& options = {})
{
    const TemporaryFolder folder;
    return refusal_of_path(folder.file(name, content), options);
}

inline void expect_has(const std::string& message, const std::string& part)
{
    EXPECT_NE(message.find(part), std::string::npos) << "\"" << part << "\" is not in: " << message;
}

} // namespace voroprobe

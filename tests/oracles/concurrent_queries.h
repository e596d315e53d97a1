#pragma once

#include <array>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "oracle_laws.h"

namespace voroprobe
{

//! What an oracle answers to one random segment.
struct OracleAnswer
{
    Region region = kOuterRegion; //!< of the source
    bool may_cross = false;       //!< the box around the segment
    std::vector<double> crossings;

    friend bool operator==(const OracleAnswer&, const OracleAnswer&) = default;
};

//! The answers to `count` random segments that `seed` determines.
inline std::vector<OracleAnswer> ask(const SurfaceOracle& oracle, std::uint64_t seed, std::size_t count)
{
    Random random(seed);
    const Box3 reach = oracle.domain().expanded(0.2 * oracle.domain().diagonal());
    std::vector<OracleAnswer> answers(count);
    std::vector<Crossing> crossings;
    for (OracleAnswer& answer : answers)
    {
        const Segment3 segment = random_segment(random, reach);
        Box3 around{segment.source, segment.source};
        around.include(segment.target);
        answer.region = oracle.region(segment.source);
        answer.may_cross = oracle.may_cross(around);
        oracle.find_crossings(segment, crossings);
        for (const Crossing& crossing : crossings)
            answer.crossings.push_back(crossing.t);
    }
    return answers;
}

//! Asserts that an oracle asked by four threads at once, each with its own segments, answers to the last bit
//! as it answers one.
inline void expect_same_answers_from_four_threads(const SurfaceOracle& oracle, std::size_t count)
{
    constexpr std::size_t kThreads = 4;
    std::array<std::vector<OracleAnswer>, kThreads> found;
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < kThreads; ++i)
        threads.emplace_back([&, i] { found[i] = ask(oracle, i, count); });
    for (std::thread& thread : threads)
        thread.join();
    for (std::size_t i = 0; i < kThreads; ++i)
        EXPECT_TRUE(found[i] == ask(oracle, i, count)) << "thread " << i;
}

} // namespace voroprobe

#pragma once

#include <cstdlib>
#include <iostream>

//! CHECK_XX(a, b): a broken invariant stops the program and shows both values. Kept in Release; for user
//! errors throw a type from error.h instead.
#define VOROPROBE_CHECK_OP(a, op, b)                                                                         \
    do                                                                                                       \
    {                                                                                                        \
        const auto& check_a = (a);                                                                           \
        const auto& check_b = (b);                                                                           \
        if (!(check_a op check_b))                                                                           \
        {                                                                                                    \
            std::cerr << __FILE__ << ":" << __LINE__ << ": check failed: " #a " " #op " " #b " (" << check_a \
                      << " vs " << check_b << ")" << std::endl;                                              \
            std::abort();                                                                                    \
        }                                                                                                    \
    } while (false)

#define CHECK(condition) VOROPROBE_CHECK_OP(static_cast<bool>(condition), ==, true)
#define CHECK_EQ(a, b) VOROPROBE_CHECK_OP(a, ==, b)
#define CHECK_NE(a, b) VOROPROBE_CHECK_OP(a, !=, b)
#define CHECK_LT(a, b) VOROPROBE_CHECK_OP(a, <, b)
#define CHECK_LE(a, b) VOROPROBE_CHECK_OP(a, <=, b)
#define CHECK_GT(a, b) VOROPROBE_CHECK_OP(a, >, b)
#define CHECK_GE(a, b) VOROPROBE_CHECK_OP(a, >=, b)

#include "oracles/implicit_expression.h"

#include <cmath>
#include <numbers>

#include "concurrent_queries.h"
#include "oracle_laws.h"
#include "oracles/expression_functions.h"
#include "oracles/expression_parser.h"
#include "oracles/sphere_union_oracle.h"
#include "support/error.h"

namespace voroprobe
{
namespace
{

const Box3 kCube{{-3, -3, -3}, {3, 3, 3}};
constexpr const char* kWavy = "x^2+y^2+z^2+sin(4*x)+sin(4*y)+sin(4*z) - 1";

std::unique_ptr<SurfaceOracle> oracle_of(const std::string& formula, const Box3& domain = kCube)
{
    return make_expression_oracle({.formula = formula}, ImplicitDomain(domain));
}

double value_of(const std::string& formula, const Point3& p = {0.5, -0.25, 2.0})
{
    return parse_expression(formula).value(p);
}

std::string refusal_of(const std::string& formula)
{
    try
    {
        oracle_of(formula);
    }
    catch (const UsageError& error)
    {
        return error.what();
    }
    return {};
}

TEST(Expression, means_what_mathematics_says)
{
    EXPECT_DOUBLE_EQ(value_of("x^2 + y^2 + z^2"), 0.25 + 0.0625 + 4.0);
    EXPECT_DOUBLE_EQ(value_of("-x^2"), -0.25);
    EXPECT_DOUBLE_EQ(value_of("2^3^2"), 512.0);
    EXPECT_DOUBLE_EQ(value_of("y^-3"), -64.0);
    EXPECT_DOUBLE_EQ(value_of("z^0.5"), std::sqrt(2.0));
    EXPECT_DOUBLE_EQ(value_of("z^x^1"), std::sqrt(2.0));
    EXPECT_DOUBLE_EQ(value_of("8^(1/3)"), std::cbrt(8.0));
    EXPECT_DOUBLE_EQ(value_of("x - y - z"), -1.25);
    EXPECT_DOUBLE_EQ(value_of("z / x / y"), -16.0);
    EXPECT_DOUBLE_EQ(value_of("+x * -y"), 0.125);
    EXPECT_DOUBLE_EQ(value_of("cos(pi) + ln(e^3) + log10(100) + log2(8)"), 7.0);
    EXPECT_DOUBLE_EQ(value_of("atan2(y, x)"), std::atan2(-0.25, 0.5));
    EXPECT_DOUBLE_EQ(value_of("min(x, y, z) + 10 * max(x, y) + 100 * min(z)"), -0.25 + 5.0 + 200.0);
    EXPECT_DOUBLE_EQ(value_of("x < y ? 1 : z > 1 ? 20 : 3"), 20.0);
    EXPECT_DOUBLE_EQ(value_of("(x > y) + (x >= y) + (x == y) + (x != y) + (x <= y)"), 3.0);
    EXPECT_DOUBLE_EQ(value_of("(x > 0 && y > 0) + 2 * (x > 0 || y > 0)"), 2.0);
    EXPECT_DOUBLE_EQ(value_of("abs(y) + sign(y) + floor(y) + ceil(y) + rint(z)"), 0.25 - 1.0 - 1.0 + 2.0);
    EXPECT_DOUBLE_EQ(value_of("3"), 3.0);
    EXPECT_DOUBLE_EQ(value_of("x"), 0.5);
}

TEST(Expression, that_does_not_parse_is_refused_with_the_place)
{
    EXPECT_NE(refusal_of("x^2+q").find("'x^2+q'"), std::string::npos) << refusal_of("x^2+q");
    EXPECT_NE(refusal_of("x^2+q").find("character 5"), std::string::npos) << refusal_of("x^2+q");
    for (const char* formula :
         {"", " ", "x+", "sin(x", "x)", "sin x", "x y", "foo(x)", "atan2(x)", "sin(x,y)", "x = 3", "x, y",
          "\"text\"", "x ? 1", "?", "1..2", "min()", "\x01"})
        EXPECT_NE(refusal_of(formula), "") << formula;
}

TEST(Expression, that_is_not_a_number_somewhere_is_refused_with_the_point)
{
    EXPECT_NE(refusal_of("sqrt(x) - 1").find("not a number at (-3"), std::string::npos)
        << refusal_of("sqrt(x) - 1");
    EXPECT_NE(refusal_of("log(x - 10)"), "");
    EXPECT_NE(refusal_of("x^0.5"), "");
    EXPECT_EQ(refusal_of("1 / x"), "") << "infinite is a side";
    EXPECT_EQ(refusal_of("sqrt(x + 3)"), "");
}

//! Formulas that together use every operation.
std::vector<std::string> formulas_of_everything()
{
    std::vector<std::string> formulas{kWavy,
                                      "x*x - y^3 / z^4",
                                      "x^-2 + y^0.7 - z^y",
                                      "atan2(y, x) * z",
                                      "min(x, y, z)",
                                      "max(x, y*y) - abs(z - 1)",
                                      "x < y ? x^2 : y - z",
                                      "(x > y) + (y <= z) * (x != z)",
                                      "(x > 1 && y > 1) - (x == 2 || z >= 1)",
                                      "-(x - y) * (x - y) * (x-y)"};
    for (const UnaryFunction& function : unary_functions())
        formulas.push_back(std::string(function.name) + "(0.3 * x * y - 0.2 * z)");
    return formulas;
}

Box3 random_box(Random& random)
{
    Box3 box;
    box.include(random_point(random, kCube));
    const double size = std::pow(10.0, random.uniform(-6.0, 0.5));
    box.include(box.min + random_point(random, {{-size, -size, -size}, {size, size, size}}));
    return box;
}

TEST(Expression, its_interval_over_a_box_holds_all_values_there)
{
    Random random(5);
    for (const std::string& formula : formulas_of_everything())
    {
        const ExpressionTape tape = parse_expression(formula);
        for (int b = 0; b < 300; ++b)
        {
            const Box3 box = random_box(random);
            const Interval values = tape.over(box);
            for (int i = 0; i < 20; ++i)
            {
                const double value = tape.value(random_point(random, box));
                ASSERT_TRUE(values.contains(value) || (std::isnan(value) && !values.is_bounded()))
                    << formula << ": " << value << " not in " << values.low << ".." << values.high;
            }
        }
    }
}

// The mean value theorem: a difference quotient is a derivative somewhere between.
TEST(Expression, its_slope_along_a_segment_holds_all_difference_quotients)
{
    Random random(6);
    for (const std::string& formula : formulas_of_everything())
    {
        const ExpressionTape tape = parse_expression(formula);
        for (int b = 0; b < 300; ++b)
        {
            const Box3 box = random_box(random);
            const Segment3 segment{box.min, box.max};
            const IntervalSlope along = tape.along(segment);
            if (!along.value.is_bounded())
                continue;
            for (int i = 0; i < 10; ++i)
            {
                const double s = random.uniform(0.0, 0.5);
                const double t = random.uniform(0.5, 1.0);
                const double a = tape.value(segment.at(s));
                const double b_value = tape.value(segment.at(t));
                ASSERT_TRUE(along.value.contains(a)) << formula;
                const double quotient = (b_value - a) / (t - s);
                const double rounding = 1e-14 * (1.0 + std::abs(a) + std::abs(b_value)) / (t - s);
                ASSERT_GE(quotient, along.slope.low - rounding) << formula;
                ASSERT_LE(quotient, along.slope.high + rounding) << formula;
            }
        }
    }
}

TEST(ExpressionOracle, finds_the_crossings_of_a_sphere_in_closed_form)
{
    const auto oracle = oracle_of("x^2 + y^2 + z^2 - 4");
    const SphereUnionOracle truth({{{0, 0, 0}, 2.0}});
    Random random(7);
    std::vector<Crossing> crossings;
    std::vector<Crossing> expected;
    for (int i = 0; i < 20000; ++i)
    {
        const Segment3 segment = random_segment(random, kCube);
        oracle->find_crossings(segment, crossings);
        truth.find_crossings(segment, expected);
        ASSERT_EQ(crossings.size(), expected.size());
        for (std::size_t c = 0; c < crossings.size(); ++c)
            ASSERT_NEAR(distance(crossings[c].point, expected[c].point), 0.0, 1e-9);
    }
}

TEST(ExpressionOracle, sees_a_shell_a_millionth_thick)
{
    const auto oracle = oracle_of("abs(sqrt(x^2 + y^2 + z^2) - 1) - 1e-6");
    std::vector<Crossing> crossings;
    oracle->find_crossings({{-2.5, 0.1, 0.2}, {2.7, 0.3, -0.1}}, crossings);
    EXPECT_EQ(crossings.size(), 4U);
    EXPECT_TRUE(oracle->may_cross({{0.99, -0.01, -0.01}, {1.01, 0.01, 0.01}}));
    EXPECT_FALSE(oracle->may_cross({{0.1, 0.1, 0.1}, {0.3, 0.3, 0.3}}));
    EXPECT_FALSE(oracle->may_cross({{1.1, 1.1, 1.1}, {2.3, 2.3, 2.3}}));
}

TEST(ExpressionOracle, counts_crossings_as_dense_sampling_does)
{
    const auto oracle = oracle_of(kWavy);
    Random random(8);
    std::vector<Crossing> crossings;
    constexpr int kSamples = 2000;
    int differing = 0;
    for (int i = 0; i < 500; ++i)
    {
        const Segment3 segment = random_segment(random, kCube);
        oracle->find_crossings(segment, crossings);
        std::size_t changes = 0;
        for (int s = 0; s < kSamples; ++s)
            changes += oracle->region(segment.at(double(s) / kSamples)) !=
                       oracle->region(segment.at(double(s + 1) / kSamples));
        ASSERT_GE(crossings.size(), changes);
        differing += crossings.size() != changes;
    }
    EXPECT_LE(differing, 5) << "sampling may miss two crossings within one step, rarely";
}

TEST(ExpressionOracle, keeps_the_laws_of_oracles)
{
    expect_laws_on_random_segments(*oracle_of(kWavy), 9, 5000);
    expect_laws_on_random_segments(*oracle_of("max(abs(x), abs(y), abs(z)) - 1"), 10, 5000);
    expect_laws_on_random_segments(*oracle_of("floor(x) + floor(y)^2 - z"), 11, 500);
    expect_laws_on_random_segments(*oracle_of("x < 0 ? y : z"), 12, 500);
    const auto in_ball = make_expression_oracle({.formula = kWavy}, ImplicitDomain({0.3, 0, 0}, 1.4));
    expect_laws_on_random_segments(*in_ball, 13, 5000);
}

TEST(ExpressionOracle, isovalue_and_inside_choose_the_object)
{
    const ImplicitDomain domain(kCube);
    const auto ball = make_expression_oracle({.formula = "x^2+y^2+z^2", .isovalue = 4.0}, domain);
    EXPECT_TRUE(is_inside(ball->region({1, 1, 1})));
    EXPECT_TRUE(is_inside(ball->region({2, 0, 0}))) << "a value equal to the isovalue is inside";
    EXPECT_FALSE(is_inside(ball->region({2, 1, 1})));
    const auto hole = make_expression_oracle(
        {.formula = "x^2+y^2+z^2", .isovalue = 4.0, .inside = InsideIs::kAbove}, domain);
    EXPECT_FALSE(is_inside(hole->region({1, 1, 1})));
    EXPECT_TRUE(is_inside(hole->region({2, 0, 0})));
    EXPECT_TRUE(is_inside(hole->region({2, 1, 1})));
}

TEST(ExpressionOracle, a_ball_cuts_the_object_with_caps)
{
    const auto half = make_expression_oracle({.formula = "x"}, ImplicitDomain({0, 0, 0}, 2.0));
    std::vector<Crossing> crossings;
    half->find_crossings({{-5, 0.5, 0}, {5, 0.5, 0}}, crossings);
    ASSERT_EQ(crossings.size(), 2U);
    EXPECT_TRUE(crossings[0].on_border);
    EXPECT_NEAR(crossings[0].point.x, -std::sqrt(3.75), 1e-12);
    EXPECT_FALSE(crossings[1].on_border);
    EXPECT_NEAR(crossings[1].point.x, 0.0, 1e-10);
    EXPECT_TRUE(half->may_cross({{-2, 0, 0}, {-1.9, 0.1, 0.1}}));
    EXPECT_FALSE(half->may_cross({{-1, 0, 0}, {-0.9, 0.1, 0.1}}));
}

TEST(ExpressionOracle, a_function_that_is_zero_all_along_ends)
{
    const auto oracle = oracle_of("sin(x)^2 + cos(x)^2 - 1");
    std::vector<Crossing> crossings;
    oracle->find_crossings({{-2, 0, 0}, {2, 1, 0}}, crossings);
    EXPECT_TRUE(keeps_the_laws(*oracle, {{-2, 0, 0}, {2, 1, 0}}, crossings));
}

TEST(ExpressionOracle, answers_four_threads_at_once_as_it_answers_one)
{
    expect_same_answers_from_four_threads(*oracle_of(kWavy), 1000);
}

TEST(ImplicitDomain, refuses_domains_without_volume)
{
    EXPECT_THROW(ImplicitDomain(Box3{}), UsageError);
    EXPECT_THROW(ImplicitDomain(Box3{{0, 0, 0}, {1, 0, 1}}), UsageError);
    EXPECT_THROW(ImplicitDomain({0, 0, 0}, 0.0), UsageError);
    EXPECT_THROW(ImplicitDomain({0, 0, 0}, std::nan("")), UsageError);
}

} // namespace
} // namespace voroprobe

// muParser does the parsing; what it compiles is then read as a tape. Its own evaluation knows numbers only,
// and needs a parser for each thread.

#include "oracles/expression_parser.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numbers>
#include <regex>
#include <utility>
#include <vector>

#include <muParser.h>

#include "oracles/expression_functions.h"
#include "support/check.h"
#include "support/error.h"

namespace voroprobe
{
namespace
{

using Slot = ExpressionTape::Slot;
using Operation = ExpressionTape::Operation;

// What muParser would call to evaluate; we tell them apart by the address it hands them. Only unary minus has
// none.

double call_unary(void* function, double a)
{
    return static_cast<const UnaryFunction*>(function)->of_number(a);
}

double call_binary(void* /*operation*/, double a, double /*b*/)
{
    return a;
}

double call_many(void* /*operation*/, const double* a, int /*count*/)
{
    return *a;
}

double call_minus(double a)
{
    return -a;
}

double call_plus(double a)
{
    return a;
}

//! The grammar: muParser's operators, our own functions, three variables.
class Grammar
{
public:
    Grammar()
    {
        parser_.EnableOptimizer(false); // operations as they are written
        parser_.ClearFun();
        parser_.ClearConst();
        parser_.ClearInfixOprt();
        parser_.DefineInfixOprt("-", call_minus);
        parser_.DefineInfixOprt("+", call_plus);
        parser_.DefineConst("pi", std::numbers::pi);
        parser_.DefineConst("e", std::numbers::e);
        parser_.DefineVar("x", &variables_[0]);
        parser_.DefineVar("y", &variables_[1]);
        parser_.DefineVar("z", &variables_[2]);
        for (const UnaryFunction& function : unary_functions())
            parser_.DefineFunUserData(function.name, call_unary, const_cast<UnaryFunction*>(&function));
        parser_.DefineFunUserData("atan2", call_binary, &atan2_);
        parser_.DefineFunUserData("min", call_many, &minimum_);
        parser_.DefineFunUserData("max", call_many, &maximum_);
    }

    //! Compiles the formula. \throw mu::ParserError; UsageError where it has not exactly one value.
    void compile(const std::string& formula)
    {
        parser_.SetExpr(formula);
        parser_.Eval(); // muParser compiles with the first evaluation
        if (parser_.GetNumResults() != 1)
            throw UsageError("the formula '" + formula + "' has " + std::to_string(parser_.GetNumResults()) +
                             " values separated by commas; it must have one");
    }

    [[nodiscard]] const mu::SToken* code() const { return parser_.GetByteCode().GetBase(); }
    [[nodiscard]] Slot variable(const double* address) const
    {
        return static_cast<Slot>(address - variables_.data());
    }

private:
    mu::Parser parser_;
    std::array<double, 3> variables_{};
    Operation atan2_ = Operation::kAtan2;
    Operation minimum_ = Operation::kMinimum;
    Operation maximum_ = Operation::kMaximum;
};

//! Reads compiled code, which is in postfix order, and keeps the slots of pending operands.
class Transcript
{
public:
    explicit Transcript(const Grammar& grammar) : grammar_(grammar) {}

    ExpressionTape take(const std::string& formula)
    {
        for (const mu::SToken* token = grammar_.code(); token->Cmd != mu::cmEND; ++token)
            read(*token, formula);
        tape_.finish(pop());
        CHECK(pending_.empty());
        return std::move(tape_);
    }

private:
    Slot pop()
    {
        CHECK(!pending_.empty());
        const Slot slot = pending_.back();
        pending_.pop_back();
        return slot;
    }

    void combine(Operation operation)
    {
        const Slot b = pop();
        const Slot a = pop();
        pending_.push_back(tape_.combine(operation, a, b));
    }

    //! a > b is b < a.
    void combine_swapped(Operation operation)
    {
        const Slot b = pop();
        const Slot a = pop();
        pending_.push_back(tape_.combine(operation, b, a));
    }

    void read(const mu::SToken& token, const std::string& formula)
    {
        switch (token.Cmd)
        {
        case mu::cmVAR:
            return pending_.push_back(grammar_.variable(token.Val.ptr));
        case mu::cmVAL:
            return pending_.push_back(tape_.constant(token.Val.data2));
        case mu::cmADD:
            return combine(Operation::kAdd);
        case mu::cmSUB:
            return combine(Operation::kSubtract);
        case mu::cmMUL:
            return combine(Operation::kMultiply);
        case mu::cmDIV:
            return combine(Operation::kDivide);
        case mu::cmPOW:
            return combine(Operation::kPower);
        case mu::cmLT:
            return combine(Operation::kLess);
        case mu::cmLE:
            return combine(Operation::kLessOrEqual);
        case mu::cmGT:
            return combine_swapped(Operation::kLess);
        case mu::cmGE:
            return combine_swapped(Operation::kLessOrEqual);
        case mu::cmEQ:
            return combine(Operation::kEqual);
        case mu::cmNEQ:
            return combine(Operation::kNotEqual);
        case mu::cmLAND:
            return combine(Operation::kAnd);
        case mu::cmLOR:
            return combine(Operation::kOr);
        case mu::cmIF:
        case mu::cmELSE:
            return; // both branches are computed; the three values wait
        case mu::cmENDIF:
            return choose();
        case mu::cmFUNC:
            return call(token);
        default:
            throw UsageError("the formula '" + formula +
                             "' uses something that is not allowed here, such as an assignment");
        }
    }

    void choose()
    {
        const Slot otherwise = pop();
        const Slot chosen = pop();
        const Slot condition = pop();
        pending_.push_back(tape_.combine(Operation::kChoose, condition, chosen, otherwise));
    }

    void call(const mu::SToken& token)
    {
        const auto function = token.Fun.cb._pRawFun;
        if (function == reinterpret_cast<mu::erased_fun_type>(call_unary))
            pending_.push_back(
                tape_.unary(*static_cast<const UnaryFunction*>(token.Fun.cb._pUserData), pop()));
        else if (function == reinterpret_cast<mu::erased_fun_type>(call_minus))
            pending_.push_back(tape_.combine(Operation::kNegate, pop()));
        else if (function == reinterpret_cast<mu::erased_fun_type>(call_binary))
            combine(*static_cast<const Operation*>(token.Fun.cb._pUserData));
        else if (function == reinterpret_cast<mu::erased_fun_type>(call_many))
            for (int i = 1; i < std::abs(token.Fun.argc); ++i) // negative: any number is allowed
                combine(*static_cast<const Operation*>(token.Fun.cb._pUserData));
        else // a plus sign changes nothing
            CHECK(function == reinterpret_cast<mu::erased_fun_type>(call_plus));
    }

    const Grammar& grammar_;
    ExpressionTape tape_;
    std::vector<Slot> pending_;
};

//! What is wrong in the words of muParser, and at which character; it counts from 0, and not every error has
//! a place.
std::string reason(const mu::ParserError& error, const std::string& formula)
{
    static const std::regex kPlace("( found)? at (expression )?position \\d+.*|\\.\\s*$");
    const std::string words = std::regex_replace(error.GetMsg(), kPlace, "");
    const int position = error.GetPos();
    if (position < 0 || formula.empty())
        return words;
    const std::size_t character = std::min(static_cast<std::size_t>(position), formula.size()) + 1;
    return words + " (character " + std::to_string(character) + ')';
}

} // namespace

ExpressionTape parse_expression(const std::string& formula)
{
    Grammar grammar;
    try
    {
        grammar.compile(formula);
    }
    catch (const mu::ParserError& error)
    {
        throw UsageError("the formula '" + formula + "' does not parse: " + reason(error, formula));
    }
    return Transcript(grammar).take(formula);
}

} // namespace voroprobe

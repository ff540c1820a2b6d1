// Integer programmes of 0-or-1 variables: what to choose so that it is worth most.
#pragma once

#include <memory>
#include <optional>
#include <vector>

namespace toile {

/// A linear sum over variables.
struct LinearTerm {
  int variable = 0;
  double factor = 0;
};

/// Maximizes a sum of worths over variables that are 0 or 1, under linear constraints. One thread;
/// the same programme gives the same answer. The work is bounded by iterations of the simplex
/// method over the life of the programme, not by a clock.
class IntegerProgramme {
 public:
  /// `max_iterations`: of all calls together.
  explicit IntegerProgramme(int max_iterations);
  ~IntegerProgramme();
  IntegerProgramme(const IntegerProgramme&) = delete;
  IntegerProgramme& operator=(const IntegerProgramme&) = delete;

  /// The number of the new variable, from 0. `implied`: it is 0 or 1 of itself where the others
  /// are.
  int add_variable(double worth, bool implied = false);
  /// The sum of the terms is at most `bound`.
  void add_at_most(const std::vector<LinearTerm>& terms, double bound);
  /// Fixes a variable.
  void fix(int variable, bool value);

  struct Answer {
    double worth = 0;
    std::vector<bool> values;
    bool proved = false;  ///< no answer is worth more
  };
  /// Nothing when no answer meets the constraints, or the iterations are used up before one is
  /// found. At most `max_nodes` nodes are searched, at least one.
  std::optional<Answer> solve(int max_nodes);
  struct Relaxed {
    double worth = 0;  ///< minus infinity: no answer meets the constraints; infinity: not known
    std::vector<double> values;  ///< 0 to 1
  };
  /// The best answer in fractions with these variables at 0: no answer in whole numbers is worth
  /// more. Not known once the iterations are used up. Call it after solve().
  Relaxed relaxed_without(const std::vector<int>& variables);

 private:
  struct Solver;
  std::unique_ptr<Solver> solver_;
};

}  // namespace toile

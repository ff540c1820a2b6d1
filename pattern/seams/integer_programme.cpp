#include "pattern/seams/integer_programme.h"

#include <coin/CbcHeuristic.hpp>
#include <coin/CbcModel.hpp>
#include <coin/ClpSimplex.hpp>
#include <coin/ClpSolve.hpp>
#include <coin/CoinPackedMatrix.hpp>
#include <coin/OsiClpSolverInterface.hpp>
#include <limits>

namespace toile {

struct IntegerProgramme::Solver {
  struct Row {
    std::vector<LinearTerm> terms;
    double bound = 0;
  };
  std::vector<double> worths;
  std::vector<double> low;
  std::vector<double> high;
  std::vector<bool> implied;
  std::vector<Row> rows;
  OsiClpSolverInterface relaxed;
  int iterations_left = 0;

  /// Solves what was changed since. False: the iterations are used up.
  bool resolve(OsiClpSolverInterface& problem) {
    if (iterations_left <= 0) return false;
    problem.getModelPtr()->setMaximumIterations(iterations_left);
    problem.resolve();
    iterations_left -= problem.getIterationCount();
    return iterations_left > 0;
  }

  void load() {
    relaxed.reset();
    relaxed.messageHandler()->setLogLevel(0);
    relaxed.getModelPtr()->setLogLevel(0);
    CoinPackedMatrix matrix(false, 0, 0);
    matrix.setDimensions(0, static_cast<int>(worths.size()));
    std::vector<double> upper;
    for (const Row& row : rows) {
      CoinPackedVector entries;
      for (const LinearTerm& term : row.terms) entries.insert(term.variable, term.factor);
      matrix.appendRow(entries);
      upper.push_back(row.bound);
    }
    const std::vector<double> lower(rows.size(), -relaxed.getInfinity());
    relaxed.loadProblem(matrix, low.data(), high.data(), worths.data(), lower.data(), upper.data());
    relaxed.setObjSense(-1);
    for (int i = 0; i < static_cast<int>(worths.size()); ++i) {
      if (!implied[i]) relaxed.setInteger(i);
    }
  }
};

IntegerProgramme::IntegerProgramme(int max_iterations) : solver_(std::make_unique<Solver>()) {
  solver_->iterations_left = max_iterations;
}
IntegerProgramme::~IntegerProgramme() = default;

int IntegerProgramme::add_variable(double worth, bool implied) {
  solver_->implied.push_back(implied);
  solver_->worths.push_back(worth);
  solver_->low.push_back(0);
  solver_->high.push_back(1);
  return static_cast<int>(solver_->worths.size()) - 1;
}

void IntegerProgramme::add_at_most(const std::vector<LinearTerm>& terms, double bound) {
  solver_->rows.push_back({terms, bound});
}

void IntegerProgramme::fix(int variable, bool value) {
  solver_->low[variable] = solver_->high[variable] = value ? 1 : 0;
}

/// A good answer in whole numbers: what the relaxed answer chooses most clearly is chosen, again
/// and again. Empty: none was found.
template <class Solver>
std::vector<double> dive(Solver& solver) {
  OsiClpSolverInterface relaxed(solver.relaxed);
  const int count = relaxed.getNumCols();
  for (int round = 0; round < count; ++round) {
    const double* values = relaxed.getColSolution();
    int most = -1;
    for (int i = 0; i < count; ++i) {
      if (solver.implied[i]) continue;
      if (values[i] > 0.99 && relaxed.getColLower()[i] == 0) relaxed.setColLower(i, 1);
      if (values[i] < 1e-6 || values[i] > 1 - 1e-6) continue;
      if (most < 0 || values[i] > values[most] + 1e-9) most = i;
    }
    if (most < 0) return {values, values + count};
    relaxed.setColLower(most, 1);
    if (!solver.resolve(relaxed) || !relaxed.isProvenOptimal()) return {};
  }
  return {};
}

std::optional<IntegerProgramme::Answer> IntegerProgramme::solve(int max_nodes) {
  solver_->load();
  OsiClpSolverInterface& relaxed = solver_->relaxed;
  // Perturbed dual simplex after presolve: by far the fastest of Clp's ways here.
  ClpSolve how;
  how.setSolveType(ClpSolve::useDual);
  how.setPresolveType(ClpSolve::presolveOn);
  if (solver_->iterations_left <= 0) return std::nullopt;
  relaxed.getModelPtr()->setPerturbation(50);
  relaxed.getModelPtr()->setMaximumIterations(solver_->iterations_left);
  relaxed.getModelPtr()->initialSolve(how);
  solver_->iterations_left -= relaxed.getModelPtr()->numberIterations();
  relaxed.setWarmStart(nullptr);
  if (!solver_->resolve(relaxed) || !relaxed.isProvenOptimal()) return std::nullopt;
  Answer answer;
  const auto take = [&](const double* solution) {
    answer.values.resize(solver_->worths.size());
    answer.worth = 0;
    for (std::size_t i = 0; i < answer.values.size(); ++i) {
      answer.values[i] = solution[i] > 0.5;
      if (answer.values[i]) answer.worth += solver_->worths[i];
    }
  };
  bool whole = true;
  for (std::size_t i = 0; i < solver_->worths.size() && whole; ++i) {
    const double value = relaxed.getColSolution()[i];
    whole = solver_->implied[i] || std::min(value, 1 - value) < 1e-7;
  }
  if (whole) {
    take(relaxed.getColSolution());
    answer.proved = true;
    return answer;
  }
  const std::vector<double> dived = dive(*solver_);
  CbcModel model(relaxed);
  model.setLogLevel(0);
  model.messageHandler()->setLogLevel(0);
  model.setMaximumNodes(max_nodes);
  model.setMaximumNumberIterations(std::max(solver_->iterations_left, 1));
  // Strong branching takes eight times the rest of a search, and finds no better seams than more
  // nodes do [measured on the samples].
  model.setNumberStrong(0);
  model.setNumberBeforeTrust(0);
  CbcRounding rounding(model);
  model.addHeuristic(&rounding);
  if (!dived.empty()) {
    double worth = 0;
    for (std::size_t i = 0; i < dived.size(); ++i) worth += dived[i] * solver_->worths[i];
    model.setBestSolution(dived.data(), static_cast<int>(dived.size()), -worth, true);
  }
  model.branchAndBound();
  solver_->iterations_left -= model.getIterationCount();
  if (model.bestSolution() == nullptr) return std::nullopt;
  take(model.bestSolution());
  answer.proved = model.isProvenOptimal();
  return answer;
}

IntegerProgramme::Relaxed IntegerProgramme::relaxed_without(const std::vector<int>& variables) {
  Relaxed result;
  result.worth = -std::numeric_limits<double>::infinity();
  OsiClpSolverInterface& relaxed = solver_->relaxed;
  for (const int variable : variables) {
    if (solver_->low[variable] > 0) return result;
  }
  for (const int variable : variables) relaxed.setColUpper(variable, 0);
  if (!solver_->resolve(relaxed)) {
    result.worth = std::numeric_limits<double>::infinity();
  } else if (relaxed.isProvenOptimal()) {
    result.worth = relaxed.getObjValue();
    result.values.assign(relaxed.getColSolution(), relaxed.getColSolution() + relaxed.getNumCols());
  }
  for (const int variable : variables) relaxed.setColUpper(variable, solver_->high[variable]);
  return result;
}

}  // namespace toile

#include "fit/solver.h"

// Not ceres/ceres.h: its jet.h asks for Bessel functions, which mingw-w64 hides in standard C++.
#include <ceres/cost_function.h>
#include <ceres/covariance.h>
#include <ceres/evaluation_callback.h>
#include <ceres/iteration_callback.h>
#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

namespace nullscope::fit {
namespace {

constexpr int kMostSteps = 40;

// Evaluates the model once for all of Ceres' blocks of residuals.
class Evaluation final : public ceres::EvaluationCallback {
public:
    Evaluation(const Problem& problem, const Steps& steps)
        : problem_(problem), steps_(steps), shares_(problem.free.size()) {}

    double* shares() { return shares_.data(); }
    const std::vector<double>& residuals() const { return residuals_; }  // in standard deviations
    const Slopes& slopes() const { return slopes_; }
    bool good() const { return good_; }
    const std::optional<Error>& error() const { return error_; }
    int predictions() const { return predictions_; }
    std::vector<double> values() const {
        std::vector<double> values;
        for (std::size_t i = 0; i < shares_.size(); ++i) values.push_back(problem_.free[i].at(shares_[i]));
        return values;
    }
    void PrepareForEvaluation(bool with_slopes, bool at_new_place) override {
        if (at_new_place) slopes_.columns.clear(), good_ = set_value();
        if (good_ && with_slopes && slopes_.columns.empty()) good_ = set_slopes();
    }

private:
    bool keep(const Error& error) {
        error_ = error;
        return false;
    }
    bool set_value() {
        ++predictions_;
        auto here = compare(problem_, values());
        if (!here) return keep(here.error());
        here_ = std::move(*here);
        residuals_.resize(here_.prediction.size());
        for (std::size_t i = 0; i < here_.prediction.size(); ++i)
            residuals_[i] = (here_.prediction[i] - problem_.data.value[i]) / problem_.data.sigma[i];
        return true;
    }
    bool set_slopes() {
        auto slopes = slopes_at(problem_, shares_, steps_, here_);
        if (!slopes) return keep(slopes.error());
        slopes_ = std::move(*slopes);
        predictions_ += slopes_.predictions;
        return true;
    }

    const Problem& problem_;
    const Steps& steps_;
    std::vector<double> shares_;
    Comparison here_;
    std::vector<double> residuals_;
    Slopes slopes_;
    bool good_ = false;
    std::optional<Error> error_;
    int predictions_ = 0;
};

class Residual final : public ceres::CostFunction {
public:
    Residual(const Evaluation& evaluation, std::size_t number, int parameters)
        : evaluation_(evaluation), number_(number) {
        set_num_residuals(1);
        mutable_parameter_block_sizes()->push_back(parameters);
    }
    bool Evaluate(double const* const*, double* residual, double** slopes) const override {
        if (!evaluation_.good()) return false;
        *residual = evaluation_.residuals()[number_];
        if (slopes != nullptr && slopes[0] != nullptr)
            for (std::size_t k = 0; k < evaluation_.slopes().columns.size(); ++k)
                slopes[0][k] = evaluation_.slopes().columns[k][number_];
        return true;
    }

private:
    const Evaluation& evaluation_;
    std::size_t number_;
};

ceres::LossFunction* loss_of(Loss loss) {
    if (loss == Loss::kHuber) return new ceres::HuberLoss(kLossBegins);
    return loss == Loss::kCauchy ? new ceres::CauchyLoss(kLossBegins) : nullptr;
}

// Standard deviations and correlations, where the data determine every parameter.
void add_covariance(ceres::Problem& least, double* shares, const Problem& problem, Solution& solution) {
    const std::size_t n = problem.free.size();
    ceres::Covariance::Options options;
    options.algorithm_type = ceres::DENSE_SVD;
    ceres::Covariance covariance(options);
    std::vector<double> matrix(n * n);
    if (!covariance.Compute(std::vector<const double*>{shares}, &least) ||
        !covariance.GetCovarianceBlock(shares, shares, matrix.data()))
        return;
    for (std::size_t i = 0; i < n; ++i)
        solution.sigma.push_back(std::sqrt(matrix[i * n + i]) * (problem.free[i].high - problem.free[i].low));
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
            solution.correlation.push_back(matrix[i * n + j] / std::sqrt(matrix[i * n + i] * matrix[j * n + j]));
}

// Ends where a step promises no change of chi^2, or makes none, were it to the worse: what is less than `least` is grain.
class Settled final : public ceres::IterationCallback {
public:
    explicit Settled(double least) : least_(least) {}
    ceres::CallbackReturnType operator()(const ceres::IterationSummary& step) override {
        if (step.iteration == 0 || !step.step_is_valid) return ceres::SOLVER_CONTINUE;
        const double made = 2 * std::fabs(step.cost_change), promised = made / std::fabs(step.relative_decrease);
        return made < least_ || promised < least_ ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
    }

private:
    double least_;
};

ceres::Solver::Options solver_options(ceres::IterationCallback* settled) {
    ceres::Solver::Options options;
    options.minimizer_type = ceres::TRUST_REGION;
    options.trust_region_strategy_type = ceres::LEVENBERG_MARQUARDT;
    options.linear_solver_type = ceres::DENSE_QR;
    options.max_num_iterations = kMostSteps;
    options.max_num_line_search_step_size_iterations =
        0;  // steps are cut at the ranges' ends: searches along them would follow the grain
    options.callbacks = {settled};
    options.logging_type = ceres::SILENT;
    return options;
}

}  // namespace

bool can_solve() { return true; }

Result<Solution> solve(const Problem& problem, const std::vector<double>& start, const Steps& steps) {
    Evaluation evaluation(problem, steps);
    const int parameters = static_cast<int>(problem.free.size());
    for (int i = 0; i < parameters; ++i)
        evaluation.shares()[i] =
            std::clamp(problem.free[static_cast<std::size_t>(i)].share(start[static_cast<std::size_t>(i)]), 0.0, 1.0);
    ceres::Problem::Options of_problem;
    of_problem.evaluation_callback = &evaluation;
    of_problem.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    const std::unique_ptr<ceres::LossFunction> loss(loss_of(problem.loss));
    ceres::Problem least(of_problem);
    for (std::size_t i = 0; i < problem.data.value.size(); ++i)
        least.AddResidualBlock(new Residual(evaluation, i, parameters), loss.get(), evaluation.shares());
    for (int i = 0; i < parameters; ++i) {
        least.SetParameterLowerBound(evaluation.shares(), i, 0.0);
        least.SetParameterUpperBound(evaluation.shares(), i, 1.0);
    }
    ceres::Solver::Summary summary;
    Settled settled(problem.settled);
    ceres::Solve(solver_options(&settled), &least, &summary);
    if (!summary.IsSolutionUsable()) return evaluation.error().value_or(failed(summary.message));
    TRY(best, compare(problem, evaluation.values()));
    Solution solution{evaluation.values(), best->flux, best->chi2, summary.termination_type != ceres::NO_CONVERGENCE};
    add_covariance(least, evaluation.shares(), problem, solution);
    solution.slope = evaluation.slopes().lengths();
    solution.why_differences = evaluation.slopes().why_differences;
    solution.predictions = evaluation.predictions() + 1;
    return solution;
}

}  // namespace nullscope::fit

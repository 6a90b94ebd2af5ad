#include "fit/solver.h"

#include <ceres/ceres.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>

namespace nullscope::fit {
namespace {

constexpr int kMostSteps = 40;

// Of the data less the prediction, in standard deviations; and of its derivatives by shares of the ranges, one column each.
struct Residuals {
    std::vector<double> value;
    std::vector<Prediction> slope;
};

// Evaluates the model once for all of Ceres' blocks of residuals.
class Evaluation final : public ceres::EvaluationCallback {
public:
    Evaluation(const Problem& problem, const Steps& steps)
        : problem_(problem), steps_(steps), shares_(problem.free.size()) {}

    double* shares() { return shares_.data(); }
    const Residuals& residuals() const { return residuals_; }
    bool good() const { return good_; }
    const std::optional<Error>& error() const { return error_; }
    int predictions() const { return predictions_; }
    std::vector<double> values() const {
        std::vector<double> values;
        for (std::size_t i = 0; i < shares_.size(); ++i) values.push_back(problem_.free[i].at(shares_[i]));
        return values;
    }
    void PrepareForEvaluation(bool with_slopes, bool at_new_place) override {
        if (at_new_place) residuals_.slope.clear(), good_ = set_value();
        if (good_ && with_slopes && residuals_.slope.empty()) good_ = set_slopes();
    }

private:
    Result<Comparison> compared(std::size_t changed, double share) {
        std::vector<double> values = this->values();
        values[changed] = problem_.free[changed].at(share);
        ++predictions_;
        return compare(problem_, values);
    }
    bool keep(const Error& error) {
        error_ = error;
        return false;
    }
    bool set_value() {
        ++predictions_;
        auto here = compare(problem_, values());
        if (!here) return keep(here.error());
        here_ = std::move(*here);
        residuals_.value.resize(here_.prediction.size());
        for (std::size_t i = 0; i < here_.prediction.size(); ++i)
            residuals_.value[i] = (here_.prediction[i] - problem_.data.value[i]) / problem_.data.sigma[i];
        return true;
    }
    bool set_slopes() {
        if (!problem_.free_flux)
            if (auto exact = problem_.model.derivatives(values())) {
                for (std::size_t k = 0; k < exact->size(); ++k)
                    scale((*exact)[k], problem_.free[k].high - problem_.free[k].low);
                residuals_.slope = std::move(*exact);
                return true;
            }
        for (std::size_t k = 0; k < shares_.size(); ++k) {
            // Both places are within the range: next to its end they are not on both sides alike.
            const double half = steps_.half[k], from = std::clamp(shares_[k] - half, 0.0, 1.0 - 2 * half);
            auto low = compared(k, from), high = compared(k, from + 2 * half);
            if (!low && !high) return keep(low.error());
            // What cannot be drawn on one side is left out.
            const double width = low && high ? 2 * half : low ? shares_[k] - from : from + 2 * half - shares_[k];
            Prediction slope = high ? std::move(high->prediction) : here_.prediction;
            const Prediction& less = low ? low->prediction : here_.prediction;
            for (std::size_t i = 0; i < slope.size(); ++i) slope[i] -= less[i];
            scale(slope, 1 / width);
            residuals_.slope.push_back(std::move(slope));
        }
        return true;
    }
    void scale(Prediction& slope, double factor) const {
        for (std::size_t i = 0; i < slope.size(); ++i) slope[i] *= factor / problem_.data.sigma[i];
    }

    const Problem& problem_;
    const Steps& steps_;
    std::vector<double> shares_;
    Comparison here_;
    Residuals residuals_;
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
        *residual = evaluation_.residuals().value[number_];
        if (slopes != nullptr && slopes[0] != nullptr)
            for (std::size_t k = 0; k < evaluation_.residuals().slope.size(); ++k)
                slopes[0][k] = evaluation_.residuals().slope[k][number_];
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
    for (const Prediction& slope : evaluation.residuals().slope)
        solution.slope.push_back(std::sqrt(std::inner_product(slope.begin(), slope.end(), slope.begin(), 0.0)));
    solution.predictions = evaluation.predictions() + 1;
    return solution;
}

}  // namespace nullscope::fit

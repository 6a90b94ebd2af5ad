// A step of the formula of order 8 by Dormand and Prince, with errors of order 5 and 3 (DOP853: Hairer, Norsett and
// Wanner, Solving Ordinary Differential Equations I, 2nd ed., II.5). Unlike Fehlberg's it has an error where the slope is
// a function of the independent variable alone, as it nearly is of light far from the hole.
#pragma once
#include <array>
#include <cmath>
#include <cstddef>

#include "reference/kerr_flow.h"

namespace nullscope::reference {

// What a step is asked and what it answers.
template <class Real>
struct FlowTask {
    FlowRay<Real> ray;
    FlowState<Real> start;
    Real length;
    Real j_weight, u_weight, c_weight;  // what errors of J, u and c are multiplied by; those of n count as they are
    FlowState<Real> end;
    Real fifth, third;  // sums of squares of the errors over the length
};

template <class Real>
class FlowStep {
public:
    FlowStep(const KerrFlow& flow, FlowTask<Real>& task) : flow_(flow), task_(task) {
        using T = Term;
        stage(0);
        stage(1, T{5.26001519587677318785587544488e-2, 0});
        stage(2, T{1.97250569845378994544595329183e-2, 0}, T{5.91751709536136983633785987549e-2, 1});
        stage(3, T{2.95875854768068491816892993775e-2, 0}, T{8.87627564304205475450678981324e-2, 2});
        stage(4, T{2.41365134159266685502369798665e-1, 0}, T{-8.84549479328286085344864962717e-1, 2},
              T{9.24834003261792003115737966543e-1, 3});
        stage(5, T{3.7037037037037037037037037037e-2, 0}, T{1.70828608729473871279604482173e-1, 3},
              T{1.25467687566822425016691814123e-1, 4});
        stage(6, T{3.7109375e-2, 0}, T{1.70252211019544039314978060272e-1, 3}, T{6.02165389804559606850219397283e-2, 4},
              T{-1.7578125e-2, 5});
        stage(7, T{3.70920001185047927108779319836e-2, 0}, T{1.70383925712239993810214054705e-1, 3},
              T{1.07262030446373284651809199168e-1, 4}, T{-1.53194377486244017527936158236e-2, 5},
              T{8.27378916381402288758473766002e-3, 6});
        stage(8, T{6.24110958716075717114429577812e-1, 0}, T{-3.36089262944694129406857109825, 3},
              T{-8.68219346841726006818189891453e-1, 4}, T{2.75920996994467083049415600797e1, 5},
              T{2.01540675504778934086186788979e1, 6}, T{-4.34898841810699588477366255144e1, 7});
        stage(9, T{4.77662536438264365890433908527e-1, 0}, T{-2.48811461997166764192642586468, 3},
              T{-5.90290826836842996371446475743e-1, 4}, T{2.12300514481811942347288949897e1, 5},
              T{1.52792336328824235832596922938e1, 6}, T{-3.32882109689848629194453265587e1, 7},
              T{-2.03312017085086261358222928593e-2, 8});
        stage(10, T{-9.3714243008598732571704021658e-1, 0}, T{5.18637242884406370830023853209, 3},
              T{1.09143734899672957818500254654, 4}, T{-8.14978701074692612513997267357, 5},
              T{-1.85200656599969598641566180701e1, 6}, T{2.27394870993505042818970056734e1, 7},
              T{2.49360555267965238987089396762, 8}, T{-3.0467644718982195003823669022, 9});
        stage(11, T{2.27331014751653820792359768449, 0}, T{-1.05344954667372501984066689879e1, 3},
              T{-2.00087205822486249909675718444, 4}, T{-1.79589318631187989172765950534e1, 5},
              T{2.79488845294199600508499808837e1, 6}, T{-2.85899827713502369474065508674, 7},
              T{-8.87285693353062954433549289258, 8}, T{1.23605671757943030647266201528e1, 9},
              T{6.43392746015763530355970484046e-1, 10});
        finish();
    }

private:
    struct Term {
        double factor;
        std::size_t stage;
    };
    template <class... Terms>
    Real sum(std::size_t n, const Terms&... terms) const {
        return (... + (terms.factor * slopes_[terms.stage][n]));
    }
    template <class... Terms>
    void stage(std::size_t i, const Terms&... terms) {
        if constexpr (sizeof...(Terms) == 0) {
            flow_.slope(task_.ray, task_.start, slopes_[i]);
        } else {
            FlowState<Real> at;
            for (std::size_t n = 0; n < kFlowSize; ++n) at[n] = task_.start[n] + task_.length * sum(n, terms...);
            flow_.slope(task_.ray, at, slopes_[i]);
        }
    }
    void finish() {
        using T = Term;
        task_.fifth = 0.0, task_.third = 0.0;
        for (std::size_t n = 0; n < kFlowSize; ++n) {
            const Real slope =
                sum(n, T{5.42937341165687622380535766363e-2, 0}, T{4.45031289275240888144113950566, 5},
                    T{1.89151789931450038304281599044, 6}, T{-5.8012039600105847814672114227, 7},
                    T{3.1116436695781989440891606237e-1, 8}, T{-1.52160949662516078556178806805e-1, 9},
                    T{2.01365400804030348374776537501e-1, 10}, T{4.47106157277725905175885569043e-2, 11});
            task_.end[n] = task_.start[n] + task_.length * slope;
            if (n == kFlowSize - 1) break;  // the clock, a quadrature, has the error of what it is of
            const Real fifth = sum(n, T{0.1312004499419488073250102996e-1, 0}, T{-0.1225156446376204440720569753e1, 5},
                                   T{-0.4957589496572501915214079952, 6}, T{0.1664377182454986536961530415e1, 7},
                                   T{-0.3503288487499736816886487290, 8}, T{0.3341791187130174790297318841, 9},
                                   T{0.8192320648511571246570742613e-1, 10}, T{-0.2235530786388629525884427845e-1, 11});
            const Real third =
                slope - sum(n, T{0.244094488188976377952755905512, 0}, T{0.733846688281611857341361741547, 8},
                            T{0.220588235294117647058823529412e-1, 11});
            const Real weight = n < 3 ? Real(1.0) : n < 5 ? task_.j_weight : n == 5 ? task_.u_weight : task_.c_weight;
            task_.fifth = task_.fifth + (weight * fifth) * (weight * fifth);
            task_.third = task_.third + (weight * third) * (weight * third);
        }
    }

    const KerrFlow& flow_;
    FlowTask<Real>& task_;
    std::array<FlowState<Real>, 12> slopes_;
};

// The error of a step over what is allowed; not finite, or not a number, where the step is of no use.
inline double step_error(const FlowTask<double>& task, double allowed) {
    constexpr double kComponents = 7;
    const double both = task.fifth + 0.01 * task.third;
    return both > 0 ? task.length * task.fifth / std::sqrt(kComponents * both) / allowed : both;
}

// How much longer the next step is than one whose error was `error` times what is allowed: 0.9 error^(-1/8), by square
// roots, which are the same on every machine.
inline double next_step(double error) {
    if (!std::isfinite(error)) return 0.2;
    return std::fmin(std::fmax(0.9 / std::sqrt(std::sqrt(std::sqrt(error))), 0.2), 5.0);
}

}  // namespace nullscope::reference

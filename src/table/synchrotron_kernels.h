// What one ultrarelativistic electron does to light of x = nu/nu_c, nu_c = 1.5 gamma^2 nu_B sine of the angle between light and field, once
// integrated over directions of motion (Westfold 1959, ApJ 130, 241; Legg and Westfold 1968, ApJ 154, 499): of I, of Q along the electric vector
// across the field, of V over 4 cot/(3 gamma).
//     i = x integral of K_5/3 beyond x,   q = x K_2/3,   v = x K_1/3 + integral of K_1/3 beyond x
// absorbed: what d(gamma^2 k)/dgamma, v also over gamma, is over 2 gamma, 2 gamma and 1: by parts it stands for -d(N/gamma^2)/dgamma.
// Faraday's are the other half of the same analytic function, Scorer's Gi in place of Airy's Ai (Huang and Shcherbakov 2011, MNRAS 416, 2574;
// Heyvaerts et al. 2013, MNRAS 430, 3320), z = (1.5 x)^(2/3): over what they are at high frequencies, conversion falls as `converted`, and
// rotation, arccosh(gamma)/(gamma sqrt(gamma^2 - 1)) there, has `turned`/gamma^2 more.
#pragma once
#include <array>
#include <cstddef>
#include <vector>

namespace nullscope {

enum SynchrotronKernel : std::size_t { kOfI, kOfQ, kOfV, kAbsorbedI, kAbsorbedQ, kAbsorbedV, kConverted, kTurned };
inline constexpr std::size_t kSynchrotronKernels = 8;
using KernelValues = std::array<double, kSynchrotronKernels>;

KernelValues synchrotron_kernels(double x);       // x in [1e-9, 700]; to 1e-10 of each; some 20 microseconds
KernelValues mean_synchrotron_kernels(double x);  // kOfI and kAbsorbedI alone: means over a field of every direction

// By cubics in ln x between equal steps, of logarithms but for the last two: to 2e-5. Beyond 700 nothing, and Faraday's as at high frequencies; below
// 1e-9 powers of x.
class KernelTable {
public:
    explicit KernelTable(bool isotropic);  // some 30 ms
    KernelValues at(double log_x) const;

private:
    std::vector<KernelValues> nodes_;
    bool isotropic_;
};
const KernelTable& kernel_table(bool isotropic);  // made once

}  // namespace nullscope

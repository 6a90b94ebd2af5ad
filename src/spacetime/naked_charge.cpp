#include "spacetime/naked_charge.h"

#include <cmath>

namespace nullscope {
NakedCharge::NakedCharge(double charge) : kappa_(0.25 * charge * charge) {
    const double inside = 1.0 + 8.0 * (1.0 - charge) * (1.0 + charge);  // 9 - 32 kappa
    traps_ = inside >= 0.0;
    zeta_d_ = traps_ ? 4.0 / (3.0 + std::sqrt(inside)) : 0.375 / kappa_;
}

std::optional<Barrier> NakedCharge::barrier() const {
    const double z = zeta_d_;
    return Barrier{z,
                   z * z * (1.0 + z * (kappa_ * z - 1.0)),
                   {traps_ ? 0.0 : z * (2.0 + z * (-3.0 + 4.0 * kappa_ * z)), 1.0 + z * (-3.0 + 6.0 * kappa_ * z),
                    4.0 * kappa_ * z - 1.0, kappa_}};
}

}  // namespace nullscope

// Reference case 13: a chain of 17 nodes after each scheme, from rational arithmetic.
#pragma once

#include <array>
#include <string_view>

namespace toile::test {

struct StrainChainRow {
  std::string_view start;
  std::string_view scheme;
  int passes;
  double max_strain;
  double mean_strain;
  double min_strain;
  double impulse;  ///< N·s for unit masses: of the anchor, or momentum gained without one
};

// clang-format off
inline constexpr std::array strain_chain_rows{
    StrainChainRow{"uniform_10pct_fixed_top", "none", 0, 0.1, 0.1, 0.1, 0},
    StrainChainRow{"uniform_10pct_fixed_top", "jacobi_sum_1", 1, 0.145, 0.0971875, 0.055, 0.5625},
    StrainChainRow{"uniform_10pct_fixed_top", "jacobi_avg_1", 1, 0.1225, 0.0971875, 0.055, 0.421875},
    StrainChainRow{"uniform_10pct_fixed_top", "jacobi_avg_3", 3, 0.12109375, 0.0947265625, 0.038125, 0.94921875},
    StrainChainRow{"uniform_10pct_fixed_top", "jacobi_sum_3", 3, 0.13375, 0.094375, 0.04375, 1.265625},
    StrainChainRow{"uniform_10pct_fixed_top", "jacobi_avg_30", 30, 0.1089210285007, 0.08268969572142, 0.01923483397217, 5.949744225469},
    StrainChainRow{"uniform_10pct_fixed_top", "gs_down_1", 1, 0.1, 0.094375, 0.01, 0.5625},
    StrainChainRow{"uniform_10pct_fixed_top", "gs_down_3", 3, 0.1, 0.089453125, 0.01, 1.6875},
    StrainChainRow{"uniform_10pct_fixed_top", "gs_down_10", 10, 0.1, 0.08017783164978, 0.009999999999998, 5.625},
    StrainChainRow{"uniform_10pct_fixed_top", "gs_down_100", 100, 0.05698196831084, 0.03787330469203, 0.01, 45.9297153759},
    StrainChainRow{"uniform_10pct_fixed_top", "gs_up_1", 1, 0.189997253418, 0.0971875, 0.01, 1.124982833862},
    StrainChainRow{"uniform_10pct_fixed_top", "gs_up_3", 3, 0.1337101745605, 0.0933203125, 0.01, 2.741835594177},
    StrainChainRow{"uniform_10pct_fixed_top", "gs_down_to_1e-3", 499, 0.01099813604374, 0.01059200211873, 0.01, 75.85066965282},
    StrainChainRow{"uniform_10pct_fixed_top", "gs_up_to_1e-3", 495, 0.01099307742573, 0.01067423760468, 0.01, 75.86016723492},
    StrainChainRow{"uniform_10pct_fixed_top", "gs_down_to_1e-4", 738, 0.01009934805779, 0.01005892409263, 0.01, 76.43536982332},
    StrainChainRow{"uniform_10pct_fixed_top", "gs_up_to_1e-4", 733, 0.0100998034026, 0.0100677602827, 0.01, 76.43569737324},
    StrainChainRow{"uniform_10pct_fixed_top", "gs_down_to_1e-6", 1215, 0.01000099378231, 0.01000058941989, 0.01, 76.49935350194},
    StrainChainRow{"uniform_10pct_fixed_top", "gs_up_to_1e-6", 1210, 0.01000099833714, 0.01000067780862, 0.01, 76.49935677844},
    StrainChainRow{"uniform_10pct_fixed_top", "gs_down_to_1e-10", 2169, 0.01000000009944, 0.01000000005898, 0.01, 76.49999993531},
    StrainChainRow{"uniform_10pct_fixed_top", "gs_up_to_1e-10", 2164, 0.01000000009989, 0.01000000006782, 0.01, 76.49999993564},
    StrainChainRow{"gravity_step_from_limit", "none", 0, 0.025696, 0.010981, 0.009999999999998, 0},
    StrainChainRow{"gravity_step_from_limit", "jacobi_sum_1", 1, 0.025696, 0.010981, 0.009999999999998, 0.0981},
    StrainChainRow{"gravity_step_from_limit", "jacobi_avg_1", 1, 0.025696, 0.010981, 0.009999999999998, 0.0981},
    StrainChainRow{"gravity_step_from_limit", "jacobi_avg_3", 3, 0.021772, 0.010981, 0.009999999999998, 0.14715},
    StrainChainRow{"gravity_step_from_limit", "jacobi_sum_3", 3, 0.021772, 0.010981, 0.009999999999998, 0.14715},
    StrainChainRow{"gravity_step_from_limit", "jacobi_avg_30", 30, 0.01425158867818, 0.01097447263622, 0.01, 0.4251588707417},
    StrainChainRow{"gravity_step_from_limit", "gs_down_1", 1, 0.017848, 0.01098097006226, 0.01, 0.0981},
    StrainChainRow{"gravity_step_from_limit", "gs_down_3", 3, 0.014905, 0.01098056590271, 0.01, 0.1839375},
    StrainChainRow{"gravity_step_from_limit", "gs_down_10", 10, 0.01276558892822, 0.01096925130745, 0.01, 0.3456986160279},
    StrainChainRow{"gravity_step_from_limit", "gs_down_100", 100, 0.01074749932963, 0.01044313985183, 0.01, 1.083489566171},
    StrainChainRow{"gravity_step_from_limit", "gs_up_1", 1, 0.025696, 0.010981, 0.009999999999998, 0.0981},
    StrainChainRow{"gravity_step_from_limit", "gs_up_3", 3, 0.015886, 0.010981, 0.009999999999998, 0.1839375},
    StrainChainRow{"gravity_step_from_limit", "gs_down_to_1e-3", 71, 0.01099239685339, 0.01058593037941, 0.01, 0.9261862573841},
    StrainChainRow{"gravity_step_from_limit", "gs_up_to_1e-3", 72, 0.01099239685339, 0.01066975896906, 0.01, 0.9323887377177},
    StrainChainRow{"gravity_step_from_limit", "gs_down_to_1e-4", 309, 0.01009935436476, 0.01005892783334, 0.01, 1.504965720368},
    StrainChainRow{"gravity_step_from_limit", "gs_up_to_1e-4", 310, 0.01009935436476, 0.01006745541402, 0.01, 1.505586685148},
    StrainChainRow{"gravity_step_from_limit", "gs_down_to_1e-6", 786, 0.0100009938454, 0.01000058945731, 0.01, 1.568953460901},
    StrainChainRow{"gravity_step_from_limit", "gs_up_to_1e-6", 787, 0.0100009938454, 0.01000067475901, 0.01, 1.568959672435},
    StrainChainRow{"gravity_step_from_limit", "gs_down_to_1e-10", 1740, 0.01000000009944, 0.01000000005898, 0.01, 1.569599935307},
    StrainChainRow{"gravity_step_from_limit", "gs_up_to_1e-10", 1741, 0.01000000009945, 0.01000000006752, 0.01, 1.569599935928},
    StrainChainRow{"uniform_10pct_heavy_end_x10", "none", 0, 0.1, 0.1, 0.1, 0},
    StrainChainRow{"uniform_10pct_heavy_end_x10", "jacobi_sum_1", 1, 0.145, 0.09948863636364, 0.055, 0.5625},
    StrainChainRow{"uniform_10pct_heavy_end_x10", "jacobi_avg_1", 1, 0.1225, 0.09948863636364, 0.07340909090909, 0.5369318181818},
    StrainChainRow{"uniform_10pct_heavy_end_x10", "jacobi_avg_3", 3, 0.12109375, 0.09881060410406, 0.06180198159279, 1.280244822971},
    StrainChainRow{"uniform_10pct_heavy_end_x10", "jacobi_sum_3", 3, 0.13375, 0.09887267561983, 0.05295454545454, 1.265625},
    StrainChainRow{"uniform_10pct_heavy_end_x10", "jacobi_avg_30", 30, 0.1089407946574, 0.0929683829319, 0.04134694854446, 8.60008158098},
    StrainChainRow{"uniform_10pct_heavy_end_x10", "gs_down_1", 1, 0.1736363636364, 0.09897727272727, 0.01, 0.5625},
    StrainChainRow{"uniform_10pct_heavy_end_x10", "gs_down_3", 3, 0.1218491735537, 0.09762120820811, 0.009999999999998, 1.6875},
    StrainChainRow{"uniform_10pct_heavy_end_x10", "gs_down_10", 10, 0.1040145170934, 0.0939736918562, 0.009999999999998, 5.625},
    StrainChainRow{"uniform_10pct_heavy_end_x10", "gs_down_100", 100, 0.08219110196878, 0.06565477248028, 0.009999999999998, 53.10156677898},
    StrainChainRow{"uniform_10pct_heavy_end_x10", "gs_up_1", 1, 0.1899995006214, 0.09948863636364, 0.01, 1.124996878884},
    StrainChainRow{"uniform_10pct_heavy_end_x10", "gs_up_3", 3, 0.1337421763167, 0.09852877300902, 0.01, 2.742119236874},
    StrainChainRow{"uniform_10pct_heavy_end_x10", "gs_down_to_1e-3", 1087, 0.01099816680931, 0.01076774962851, 0.009999999999998, 156.0593217403},
    StrainChainRow{"uniform_10pct_heavy_end_x10", "gs_up_to_1e-3", 1081, 0.01099932743081, 0.0108167894373, 0.01, 156.0638923837},
    StrainChainRow{"uniform_10pct_heavy_end_x10", "gs_down_to_1e-4", 1618, 0.01009963843438, 0.0100766378628, 0.01, 157.3561894416},
    StrainChainRow{"uniform_10pct_heavy_end_x10", "gs_up_to_1e-4", 1612, 0.01009975428927, 0.01008153308644, 0.01, 157.3566456897},
    StrainChainRow{"uniform_10pct_heavy_end_x10", "gs_down_to_1e-6", 2679, 0.01000099714688, 0.01000076696514, 0.01, 157.4985607938},
    StrainChainRow{"uniform_10pct_heavy_end_x10", "gs_up_to_1e-6", 2673, 0.01000099830632, 0.01000081595484, 0.01, 157.4985653598},
    StrainChainRow{"uniform_10pct_heavy_end_x10", "gs_down_to_1e-10", 4801, 0.01000000009987, 0.01000000007681, 0.01, 157.4999998559},
    StrainChainRow{"uniform_10pct_heavy_end_x10", "gs_up_to_1e-10", 4795, 0.01000000009998, 0.01000000008172, 0.01, 157.4999998563},
    StrainChainRow{"uniform_10pct_both_ends_free", "none", 0, 0.1, 0.1, 0.1, 0},
    StrainChainRow{"uniform_10pct_both_ends_free", "jacobi_sum_1", 1, 0.1, 0.094375, 0.055, 0},
    StrainChainRow{"uniform_10pct_both_ends_free", "jacobi_avg_1", 1, 0.1, 0.094375, 0.055, 0},
    StrainChainRow{"uniform_10pct_both_ends_free", "jacobi_avg_3", 3, 0.1, 0.089453125, 0.038125, 0},
    StrainChainRow{"uniform_10pct_both_ends_free", "jacobi_sum_3", 3, 0.1, 0.08875, 0.04375, 0},
    StrainChainRow{"uniform_10pct_both_ends_free", "jacobi_avg_30", 30, 0.09286893732795, 0.06538023302289, 0.01922932744039, 0},
    StrainChainRow{"uniform_10pct_both_ends_free", "gs_down_1", 1, 0.09999862670898, 0.09156258583069, 0.01, 0},
    StrainChainRow{"uniform_10pct_both_ends_free", "gs_down_3", 3, 0.099934425354, 0.08277505755425, 0.01, 0},
    StrainChainRow{"uniform_10pct_both_ends_free", "gs_down_10", 10, 0.09110106214881, 0.0650695892972, 0.009999999999998, 0},
    StrainChainRow{"uniform_10pct_both_ends_free", "gs_down_100", 100, 0.0138361447928, 0.01253152227048, 0.01, 0},
    StrainChainRow{"uniform_10pct_both_ends_free", "gs_up_1", 1, 0.09999862670898, 0.09156258583069, 0.01, 0},
    StrainChainRow{"uniform_10pct_both_ends_free", "gs_up_3", 3, 0.099934425354, 0.08277505755425, 0.01, 0},
    StrainChainRow{"uniform_10pct_both_ends_free", "gs_down_to_1e-3", 140, 0.01097101589561, 0.01064078645719, 0.01, 0},
    StrainChainRow{"uniform_10pct_both_ends_free", "gs_up_to_1e-3", 140, 0.01097101589562, 0.01064078645719, 0.01, 0},
    StrainChainRow{"uniform_10pct_both_ends_free", "gs_down_to_1e-4", 207, 0.01009723109307, 0.01006416410732, 0.01, 0},
    StrainChainRow{"uniform_10pct_both_ends_free", "gs_up_to_1e-4", 207, 0.01009723109307, 0.01006416410732, 0.01, 0},
    StrainChainRow{"uniform_10pct_both_ends_free", "gs_down_to_1e-6", 341, 0.01000097490614, 0.01000064335369, 0.01, 0},
    StrainChainRow{"uniform_10pct_both_ends_free", "gs_up_to_1e-6", 341, 0.01000097490614, 0.01000064335369, 0.01, 0},
    StrainChainRow{"uniform_10pct_both_ends_free", "gs_down_to_1e-10", 609, 0.01000000009801, 0.01000000006468, 0.01, 0},
    StrainChainRow{"uniform_10pct_both_ends_free", "gs_up_to_1e-10", 609, 0.01000000009801, 0.01000000006468, 0.01, 0},
};
// clang-format on

}  // namespace toile::test

/* SPDX-License-Identifier: MIT */
#include "draw/submit_surface.c"
#include "proof.h"

/* Coordinates are within FXL_TEXEL_MAX. */
void prove_has_few_texels(void)
{
    int32_t values[FXL_ATTRIBUTES][3];
    int64_t most = 0, least = 0;
    for (int i = FXL_ATTRIBUTE_U; i <= FXL_ATTRIBUTE_V; i++) {
        for (int j = 0; j < 3; j++) {
            ASSUME(WITHIN(values[i][j], (1 << 30) - 1));
            const int64_t difference = (int64_t)values[i][j] - values[i][0];
            most = difference > most ? difference : most;
            least = difference < least ? difference : least;
        }
    }
    ASSERT("128 texels from the first corner's", has_few_texels(values) == (most < 1 << 23 && least >= -(1 << 23)));
    PROOF_ENDS();
}

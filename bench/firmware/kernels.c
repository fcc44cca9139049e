/* SPDX-License-Identifier: MIT */
/* Measures the library's kernels, each over many inputs as one region, and the limits that they
 * are compared with. Prints for each region
 *   bench: kernel NAME UNITS
 * A figure is that of the whole loop: fetching the input, the call, storing the result. "call"
 * is the same loop with an empty function. A name that begins with "limit-" is the bare work,
 * for comparison. */
#include "contract/system.h"
#include "kernels.h"
#include "program.h"

static kernel_inputs inputs;

static void run(const bench_kernel *kernel)
{
    bench_begin();
    kernel->run(&inputs);
    bench_end();
    text_with_number("bench: kernel ", kernel->name, " ", kernel->units);
}

int main(int argc, char **argv)
{
    bench_start(argc, argv);
    kernel_inputs_make(&inputs);
    for (const bench_kernel *each = kernel_list; each->name != NULL; each++) {
        run(each);
    }
    if (!kernel_surfaces_prepare() || !kernel_depth_prepare()) {
        system_exit(SYSTEM_EXIT_RENDER);
    }
    for (const bench_kernel *each = surface_list; each->name != NULL; each++) {
        run(each);
    }
    for (const bench_kernel *each = depth_list; each->name != NULL; each++) {
        run(each);
    }
    for (const bench_kernel *each = limit_list; each->name != NULL; each++) {
        run(each);
    }
    system_exit(SYSTEM_EXIT_DONE);
    return SYSTEM_EXIT_DONE; /* not reached */
}

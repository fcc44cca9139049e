/* SPDX-License-Identifier: MIT */
/* Runs a fuzz target on files, without a fuzzer: the corpus as a test, on any
 * compiler. Usage: replay_TARGET FILE... */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum {
    FILE_MAX = 1 << 20
};

int main(int count, char **names)
{
    static uint8_t bytes[FILE_MAX];
    for (int i = 1; i < count; i++) {
        FILE *file = fopen(names[i], "rb");
        if (file == NULL) {
            fprintf(stderr, "error: %s: cannot be read\n", names[i]);
            return 2;
        }
        size_t size = fread(bytes, 1, sizeof bytes, file);
        fclose(file);
        fprintf(stderr, "%s: %zu bytes\n", names[i], size);
        LLVMFuzzerTestOneInput(bytes, size);
    }
    printf("%d inputs\n", count - 1);
    return 0;
}

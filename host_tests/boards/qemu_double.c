/* SPDX-License-Identifier: MIT */
/* A double of QEMU's side of the plugin interface, for the test of bench/plugin:
 * loads a plugin, says which version of the interface it wants, translates the
 * blocks and runs the way through them that stdin names. With SCOREBOARD it has
 * what QEMU has since version 2 of the interface.
 *
 *   qemu_double PLUGIN ARGUMENT...
 *   block ADDRESS SIZES     (hexadecimal; a digit for each instruction: 2 or 4, or 3 for one of 2
 *                            that is told to be 4, as QEMU 7 tells it before the end of a page)
 *   run ADDRESS */
#include <dlfcn.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#define BLOCKS 64

struct qemu_plugin_insn {
    uint64_t address;
    size_t size;
};
struct qemu_plugin_tb {
    uint64_t address;
    size_t count;
    struct qemu_plugin_insn instructions[32];
    void (*executed)(unsigned core, void *data);
    void *data;
};

static struct qemu_plugin_tb blocks[BLOCKS];
static size_t block_count;
static void (*translated)(uint64_t id, struct qemu_plugin_tb *block);
static void (*exiting)(uint64_t id, void *data);
static void *exiting_data;

void qemu_plugin_register_vcpu_tb_trans_cb(uint64_t id,
                                           void (*callback)(uint64_t, struct qemu_plugin_tb *));
void qemu_plugin_register_vcpu_tb_exec_cb(struct qemu_plugin_tb *block,
                                          void (*callback)(unsigned, void *), int registers,
                                          void *data);
void qemu_plugin_register_atexit_cb(uint64_t id, void (*callback)(uint64_t, void *), void *data);
size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb *block);
uint64_t qemu_plugin_tb_vaddr(const struct qemu_plugin_tb *block);
struct qemu_plugin_insn *qemu_plugin_tb_get_insn(struct qemu_plugin_tb *block, size_t index);
size_t qemu_plugin_insn_size(const struct qemu_plugin_insn *instruction);
uint64_t qemu_plugin_insn_vaddr(const struct qemu_plugin_insn *instruction);

void qemu_plugin_register_vcpu_tb_trans_cb(uint64_t id,
                                           void (*callback)(uint64_t, struct qemu_plugin_tb *))
{
    (void)id;
    translated = callback;
}

void qemu_plugin_register_vcpu_tb_exec_cb(struct qemu_plugin_tb *block,
                                          void (*callback)(unsigned, void *), int registers,
                                          void *data)
{
    (void)registers;
    block->executed = callback;
    block->data = data;
}

void qemu_plugin_register_atexit_cb(uint64_t id, void (*callback)(uint64_t, void *), void *data)
{
    (void)id;
    exiting = callback;
    exiting_data = data;
}

size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb *block)
{
    return block->count;
}

uint64_t qemu_plugin_tb_vaddr(const struct qemu_plugin_tb *block)
{
    return block->address;
}

struct qemu_plugin_insn *qemu_plugin_tb_get_insn(struct qemu_plugin_tb *block, size_t index)
{
    return &block->instructions[index];
}

size_t qemu_plugin_insn_size(const struct qemu_plugin_insn *instruction)
{
    return instruction->size;
}

uint64_t qemu_plugin_insn_vaddr(const struct qemu_plugin_insn *instruction)
{
    return instruction->address;
}

#ifdef SCOREBOARD
void *qemu_plugin_scoreboard_new(size_t size);
void *qemu_plugin_scoreboard_new(size_t size)
{
    (void)size;
    return NULL;
}
#endif

static int translate(uint64_t address, const char *sizes)
{
    struct qemu_plugin_tb *made = &blocks[block_count];
    if (block_count == BLOCKS || strlen(sizes) > 32) {
        return 1;
    }
    made->address = address;
    for (; sizes[made->count] != '\0'; made->count++) {
        struct qemu_plugin_insn *instruction = &made->instructions[made->count];
        instruction->address = address;
        instruction->size = (size_t)((sizes[made->count] & ~1) - '0');
        address += instruction->size;
        instruction->size += sizes[made->count] & 1 ? 2 : 0;
    }
    block_count++;
    translated(1, made);
    return 0;
}

static int run(uint64_t address)
{
    for (size_t i = 0; i < block_count; i++) {
        if (blocks[i].address == address) {
            blocks[i].executed(0, blocks[i].data);
            return 0;
        }
    }
    return 1;
}

int main(int argc, char **argv)
{
    void *plugin = argc < 2 ? NULL : dlopen(argv[1], RTLD_NOW);
    int (*install)(uint64_t, const void *, int, char **);
    const int *version;
    char word[16], sizes[64];
    unsigned long long address;

    if (plugin == NULL) {
        fprintf(stderr, "%s\n", dlerror());
        return 2;
    }
    version = dlsym(plugin, "qemu_plugin_version");
    *(void **)&install = dlsym(plugin, "qemu_plugin_install");
    printf("version %d\n", *version);
    if (install(1, NULL, argc - 2, argv + 2) != 0) {
        return 3;
    }
    while (scanf("%15s %llx", word, &address) == 2) {
        int bad = strcmp(word, "block") == 0
                      ? scanf("%63s", sizes) != 1 || translate(address, sizes)
                      : run(address);
        if (bad) {
            return 4;
        }
    }
    exiting(1, exiting_data);
    return 0;
}

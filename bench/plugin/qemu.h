/* SPDX-License-Identifier: MIT */
/* The part of QEMU's plugin interface that the counter uses. No Debian package
 * ships the header; these few functions are public and the same in every
 * version of the interface from 1 (QEMU 4.2 to 8.2) on. What changed between
 * versions (the instruction's bytes, operations inlined into the code) is not
 * used here. */
#ifndef PLUGIN_QEMU_H
#define PLUGIN_QEMU_H

#include <stddef.h>
#include <stdint.h>

/* QEMU hides and looks up names by itself: these two must be visible. */
#define PLUGIN_EXPORT __attribute__((visibility("default")))

typedef uint64_t qemu_plugin_id_t;

/* A block of instructions as QEMU translated them, and one of its
 * instructions; both are QEMU's, and live while it translates. */
struct qemu_plugin_tb;
struct qemu_plugin_insn;

/* Which of the core's registers a callback looks at: none. */
enum {
    PLUGIN_NO_REGISTERS = 0
};

typedef void (*qemu_plugin_on_translated)(qemu_plugin_id_t id, struct qemu_plugin_tb *block);
typedef void (*qemu_plugin_on_executed)(unsigned core, void *data);
typedef void (*qemu_plugin_on_exit)(qemu_plugin_id_t id, void *data);

/* Given by QEMU. A block is told as executed before its first instruction. */
void qemu_plugin_register_vcpu_tb_trans_cb(qemu_plugin_id_t id, qemu_plugin_on_translated callback);
void qemu_plugin_register_vcpu_tb_exec_cb(struct qemu_plugin_tb *block,
                                          qemu_plugin_on_executed callback, int registers,
                                          void *data);
void qemu_plugin_register_atexit_cb(qemu_plugin_id_t id, qemu_plugin_on_exit callback, void *data);
size_t qemu_plugin_tb_n_insns(const struct qemu_plugin_tb *block);
uint64_t qemu_plugin_tb_vaddr(const struct qemu_plugin_tb *block);
struct qemu_plugin_insn *qemu_plugin_tb_get_insn(const struct qemu_plugin_tb *block, size_t index);
size_t qemu_plugin_insn_size(const struct qemu_plugin_insn *instruction);
uint64_t qemu_plugin_insn_vaddr(const struct qemu_plugin_insn *instruction);

/* Asked for by QEMU: the version of the interface that the plugin was written
 * for, and the entry, which answers 0 where all is well. */
extern PLUGIN_EXPORT int qemu_plugin_version;
struct qemu_info_t;
PLUGIN_EXPORT int qemu_plugin_install(qemu_plugin_id_t id, const struct qemu_info_t *info, int argc,
                                      char **argv);

#endif

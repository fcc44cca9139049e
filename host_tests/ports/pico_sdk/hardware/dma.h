/* SPDX-License-Identifier: MIT */
#ifndef PORTS_HARDWARE_DMA_H
#define PORTS_HARDWARE_DMA_H
#include "pico/stdlib.h"
enum dma_channel_transfer_size {
    DMA_SIZE_8,
    DMA_SIZE_16,
    DMA_SIZE_32
};
typedef struct {
    uint32_t ctrl;
} dma_channel_config;
int dma_claim_unused_channel(bool required);
dma_channel_config dma_channel_get_default_config(uint channel);
void channel_config_set_transfer_data_size(dma_channel_config *config,
                                           enum dma_channel_transfer_size size);
void channel_config_set_dreq(dma_channel_config *config, uint dreq);
void dma_channel_configure(uint channel, const dma_channel_config *config,
                           volatile void *write_address, const volatile void *read_address,
                           uint count, bool trigger);
bool dma_channel_is_busy(uint channel);
#endif

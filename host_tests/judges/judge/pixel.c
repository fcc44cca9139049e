/* SPDX-License-Identifier: MIT */
#include "judge/pixel.h"

#include <stdlib.h>

judge_box *judge_boxes_of(const ref_display_list *list)
{
    judge_box *boxes = malloc((list->count + 1) * sizeof *boxes);
    for (size_t i = 0; boxes && i < list->count; i++) {
        boxes[i] = judge_box_of_drawn(&list->drawn[i]);
    }
    return boxes;
}

/* place pixel-format: which colours a pixel may have */
judge_reason judge_pixel(const ref_renderer *renderer, const judge_box *boxes, uint8_t background,
                         int line, int x, int y, uint16_t colour, double limit)
{
    const ref_display_list *list = &renderer->display_list;
    const double resolution = ref_depth_resolution(&renderer->lens, renderer->depth_bits);
    const int ways = renderer->scene->surfaces ? 4 : 2;
    judge_question question = {.x = x,
                               .y = y,
                               .colour = colour,
                               .rgb565 = renderer->rgb565,
                               .background = background,
                               .line = line < 0 ? line : ref_pixel_of(renderer, (uint8_t)line)};
    judge_reason reason = {0};
    for (int way = 0; way < ways; way++) {
        question.doubt = way & 1;
        question.texels = way & 2;
        const double distance =
            renderer->depth_bits != 0
                ? judge_explain_by_depth(&renderer->lens, list->drawn, boxes, list->count,
                                         &question, resolution)
                : judge_explain(&renderer->lens, list->drawn, boxes, list->count, &question);
        if (distance <= limit) {
            return (judge_reason){distance, question.doubt, question.texels};
        }
        if (way == 0) {
            reason.distance = distance;
        }
    }
    return reason;
}

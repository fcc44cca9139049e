# SPDX-License-Identifier: MIT
"""From a scene file to a scene image: objects, places, motions, paths, colours, textures, light, trees."""

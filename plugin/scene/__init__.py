# SPDX-License-Identifier: GPL-3.0-or-later
"""A Blender scene as burnish takes it: what the frame needs to hold, and what surrounds it. Knows bpy, not burnish.

values      a number of a shader: known, or one that an AOV has to show
links       what feeds a socket, past reroutes, muted nodes and groups
shaders     a material's nodes as specular lobes      principled  the Principled BSDF as lobes
layers      the lobes' numbers as AOVs of the frame
passes      prepare: passes, ids and AOVs switched on  touched     what that changed, and back again
checks      what would spoil the result
materials   world (world_picture)   lamps (glowing: of mesh)   camera   parts of a shot file
mirrors     flat glossy surfaces                       bake        cube maps and mirrors rendered for them
borrowed    settings changed for the time of a render  renders     that render
fingerprint whether a picture still shows what it was made of
"""

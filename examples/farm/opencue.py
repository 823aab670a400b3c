"""OpenCue: a layer of the frames of a shot file.

    python3 examples/farm/opencue.py shot.json 1-200 10

OpenCue writes the first and last frame of a chunk where the tokens stand. The last chunk may go beyond the range: --within leaves out what is
none of the job's. A frame that is missing inside the range fails its chunk; with --bad-frames skip it is passed over (exit code 3).
"""

import sys


def command(shot, frames):
    """What a chunk runs."""
    return ["burnish", "sequence", shot, "--frames", "#FRAME_START#-#FRAME_END#", "--within", frames]


def main(shot, frames, chunk="10"):
    """Send the job."""
    import getpass

    import outline
    import outline.cuerun
    import outline.modules.shell

    job = outline.Outline("burnish", shot="shot", show="show", user=getpass.getuser())
    job.add_layer(outline.modules.shell.Shell("composite", command=command(shot, frames), range=frames, chunk=int(chunk), threads=2))
    outline.cuerun.launch(job, use_pycuerun=False)


if __name__ == "__main__":
    main(*sys.argv[1:])

from glob import glob

from setuptools import setup

setup(
    name='robot',
    data_files=[('share/robot/launch', glob('launch/*')), ('share/robot/config', glob('config/*.yaml'))],
    entry_points={'console_scripts': [
        'talker = robot.talker:main',
    ]},
)

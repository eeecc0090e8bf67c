"""What package.xml, setup.py and CMakeLists.txt say of a package, held against its code and its files."""
